#pragma once

#include "scenarios/config/config_visitor.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::config {

/// Each shows `v` every key of a struct, its meaning, unit, range and place. There is no other list of them.
void Describe(ConfigVisitor& v, runner::Scenario& scenario);

void Describe(ConfigVisitor& v, runner::Start& start);
void Describe(ConfigVisitor& v, controller::Manoeuvre& manoeuvre);
void Describe(ConfigVisitor& v, runner::Event& event);
void Describe(ConfigVisitor& v, runner::Criterion& criterion);

/// What `calibration` leaves out are the truth's keys: of the camera and the vehicle.
void DescribeCalibration(ConfigVisitor& v, runner::Calibration& calibration, const models::CameraModel& camera,
                         const models::Vehicle& vehicle);

/// The same of a file that is read by itself: what a section leaves out is the default.
void Describe(ConfigVisitor& v, runner::Calibration& calibration);

void Describe(ConfigVisitor& v, models::Vehicle& vehicle);
void Describe(ConfigVisitor& v, models::Mounting& mounting);
void Describe(ConfigVisitor& v, models::CameraModel& model);
void Describe(ConfigVisitor& v, models::LandingPad& pad);
void Describe(ConfigVisitor& v, models::PadMark& mark);
void Describe(ConfigVisitor& v, sim::ImuConfig& config);
void Describe(ConfigVisitor& v, sim::TrackingSystemConfig& config);
void Describe(ConfigVisitor& v, sim::HandConfig& config);
void Describe(ConfigVisitor& v, sim::SceneConfig& config);
void Describe(ConfigVisitor& v, sim::WorldConfig& config);
void DescribeCamera(ConfigVisitor& v, sim::CameraConfig& config, const models::TimeBase& time);

void Describe(ConfigVisitor& v, estimator::paper::PaperOptions& config);
void Describe(ConfigVisitor& v, estimator::EstimatorConfig& config);
void Describe(ConfigVisitor& v, estimator::AttitudeEstimatorConfig& config);
void Describe(ConfigVisitor& v, estimator::PoseFilterConfig& config);
void Describe(ConfigVisitor& v, controller::GuidanceConfig& config);
void Describe(ConfigVisitor& v, controller::PositionControllerConfig& config);
void Describe(ConfigVisitor& v, controller::AttitudeControllerConfig& config);
void Describe(ConfigVisitor& v, controller::FlightControllerConfig& config);

}  // namespace touchdown::config
