#include "scenarios/runner/scenario_schema.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario_checks.h"

namespace touchdown::runner {
namespace {

using models::Between, models::ConfigVisitor, models::kAny, models::kMeter, models::kNoUnit, models::kPositiveTime,
    models::kSecond, models::kTime;

/// A flight that ends in an error has no other verdict: it cannot be expected.
constexpr auto kExpectableOutcomes = std::span(kOutcomeNames).first<4>();
static_assert(kOutcomeNames[4] == "error");

bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name[0] != '.' && name[0] != '-' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                  c == '.';
         });
}

void DescribeStory(ConfigVisitor& v, Scenario& s) {
  v.Text({"name", "Name of the flight: letters, digits, _, - and . only. Default: the file's name."}, s.name);
  v.Text({"description", "Purpose of the flight in words."}, s.description);
  v.Integer({"seed", "Seed of every random source."}, s.seed, models::kNotNegative);
  v.Number({"time_limit_s", "Time after which the flight ends as gave_up."}, s.time_limit_s, kSecond, kPositiveTime);
  int expect = s.expect ? static_cast<int>(*s.expect) : -1;
  v.Choice({"expect", "Expected outcome. Default: landed after a script that ends with a landing, else hovered."},
           expect, kExpectableOutcomes);
  if (expect >= 0) s.expect = static_cast<Outcome>(expect);
  v.Keys({"start", "Initial state of the vehicle, at rest."}, s.start);
  v.Keys({"hand", "A hand that carries the vehicle over the pad, motors off, in place of a flight (Sec. VI-B.1)."},
         s.hand);
  v.Items({"script", "Maneuvers to fly, in order. It is empty when a hand carries the vehicle."}, s.script);
  v.Items({"events", "Disturbances during the flight."}, s.events);
  v.Items({"criteria", "Bounds on metrics. A flight passes when it keeps them and ends as expected."}, s.criteria);
  v.Check("name", [&s] {
    if (!IsPlainName(s.name)) throw InputError("must be letters, digits, _, - and . only");
  });
  v.Check("script", [&s] {
    if (s.hand.carries && !s.script.empty()) throw InputError("must be empty: hand.carries is true");
    if (!s.hand.carries && s.script.empty()) throw InputError("must not be empty");
  });
}

/// A sensor whose rate must divide the ticks.
template <typename Sensor>
void DescribeSensor(ConfigVisitor& v, const models::Key& key, Sensor& sensor, const models::TimeBase& time,
                    const models::SectionFile& file = {}) {
  v.Section(key, file, [&sensor, &time](ConfigVisitor& s) {
    Describe(s, sensor);
    s.Check("", [&sensor, &time] { sensor.Validate(time); });
  });
}

void DescribeSimulation(ConfigVisitor& v, Scenario& s) {
  v.Keys({"time", "Clock of the simulation."}, s.time);
  v.Keys({"vehicle", "The quadrotor: in place, or the name of a file."}, s.vehicle, models::kOrFile);
  v.Keys({"pad", "The landing pad: in place, or the name of a file."}, s.pad, models::kOrFile);
  DescribeSensor(
      v,
      {"camera", "The downward camera: in place, or the name of a file with these keys or of a ROS camera_info file."},
      s.camera, s.time, {.allowed = true, .format = models::kCameraModelFile.format, .format_key = "model"});
  DescribeSensor(v, {"imu", "The inertial measurement unit."}, s.imu, s.time);
  DescribeSensor(v, {"tracking", "The external tracking system, which writes tracking.csv."}, s.tracking, s.time);
  v.Keys({"scene", "Surroundings of the pad. The layout is drawn from the seed."}, s.scene);
  v.Keys({"world", "Wind, tilt of the ground, and vibration."}, s.world);
}

void DescribeCalibrationKeys(ConfigVisitor& v, Calibration& c, const models::CameraModel& camera,
                             const models::Vehicle& vehicle) {
  v.OptionalKeys({"camera_model",
                  "Camera model assumed instead of camera.model: in place, or the name of a ROS camera_info file."},
                 c.camera_model, camera, models::kCameraModelFile);
  v.OptionalKeys({"camera", "Camera mounting assumed instead of vehicle.camera."}, c.camera, vehicle.camera);
  v.OptionalKeys({"imu", "IMU mounting assumed instead of vehicle.imu."}, c.imu, vehicle.imu);
}

void DescribeAutopilot(ConfigVisitor& v, Scenario& s) {
  v.Keys({"estimator", "Estimator: IMU samples and frames to the state of the vehicle."}, s.estimator);
  v.Keys({"attitude_estimator", "Attitude filter: roll and pitch from the IMU, yaw from vision."},
         s.estimator.filters.attitude);
  v.Keys({"pose_filter", "Kalman filter on vision's position."}, s.estimator.filters.pose_filter);
  v.Keys({"controller", "Controller: guidance, position loop, attitude loop."}, s.controller);
}

}  // namespace

void Describe(ConfigVisitor& v, Start& start) {
  const models::Range room = Between(-15.0, 15.0);
  v.Boolean({"airborne",
             "Whether the vehicle starts in the air with its rotors turning. Otherwise it stands on the ground, motors "
             "off."},
            start.airborne);
  if (start.airborne) {
    v.Vector3({"position_m", "Initial position of the body's origin in W (airborne only)."}, start.position_m, kMeter,
              room);
  } else {
    v.Number({"x_m", "Initial X of the body's origin in W (on the ground only)."}, start.position_m.x(), kMeter, room);
    v.Number({"y_m", "Initial Y of the body's origin in W (on the ground only)."}, start.position_m.y(), kMeter, room);
  }
  v.Number({"yaw_deg",
            "Initial heading, at most 90 degrees to either side: the side of the starting heading defines W's X axis."},
           start.yaw_deg, models::kDegree, Between(-90.0, 90.0));
}

void Describe(ConfigVisitor& v, Criterion& criterion) {
  v.Text({"metric", "Name of the metric.", true}, criterion.metric);
  v.OptionalNumber({"min", "Smallest value that passes, in the unit of the metric's name."}, criterion.min, kNoUnit,
                   kAny);
  v.OptionalNumber({"max", "Largest value that passes, in the unit of the metric's name."}, criterion.max, kNoUnit,
                   kAny);
  v.Check("metric", [&criterion] {
    if (FindMetric(criterion.metric) == nullptr) throw InputError(fmt::format("unknown metric '{}'", criterion.metric));
  });
  v.Check("", [&criterion] {
    if (!criterion.min && !criterion.max) throw InputError("needs a min or a max");
    if (criterion.min && criterion.max && *criterion.min > *criterion.max) throw InputError("its min is over its max");
  });
}

void DescribeCalibration(ConfigVisitor& v, Scenario& s) {
  v.Section({"calibration",
             "Camera and mountings as estimator and controller assume them, where they differ from the truth: in "
             "place, or the name of a file."},
            models::kOrFile,
            [&s](ConfigVisitor& c) { DescribeCalibrationKeys(c, s.calibration, s.camera.model, s.vehicle); });
}

void Describe(ConfigVisitor& v, Calibration& calibration) { DescribeCalibrationKeys(v, calibration, {}, {}); }

void Describe(ConfigVisitor& v, Scenario& s) {
  DescribeStory(v, s);
  DescribeSimulation(v, s);
  DescribeCalibration(v, s);
  DescribeAutopilot(v, s);
  CheckScenario(v, s);
}

}  // namespace touchdown::runner
