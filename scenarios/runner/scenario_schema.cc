#include "scenarios/runner/scenario_schema.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario_checks.h"

namespace touchdown::runner {
namespace {

using models::Between, models::ConfigVisitor, models::kAny, models::kMeter, models::kNoUnit, models::kPositiveTime,
    models::kSecond, models::kTime;

/// Outcomes that a scenario can expect. The verdict of an outcome `error` is always `error`, so it cannot be expected.
constexpr auto kExpectableOutcomes = std::span(kOutcomeNames).first<4>();
static_assert(kOutcomeNames[4] == "error");

bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name[0] != '.' && name[0] != '-' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                  c == '.';
         });
}

void DescribeFlight(ConfigVisitor& v, Scenario& s) {
  v.Text(
      {"name", "Name of the flight. It may contain letters, digits, _, - and . only. Default: the name of the file."},
      s.name);
  v.Text({"description", "Purpose of the flight, as free text."}, s.description);
  v.Integer({"seed", "Seed from which every random stream of the flight is derived."}, s.seed, models::kNotNegative);
  v.Number({"time_limit_s", "Time after which the flight ends as gave_up."}, s.time_limit_s, kSecond, kPositiveTime);
  int expect = s.expect ? static_cast<int>(*s.expect) : -1;
  v.Choice({"expect", "Expected outcome. Default: landed after a script that ends with a landing, else hovered."},
           expect, kExpectableOutcomes);
  if (expect >= 0) s.expect = static_cast<Outcome>(expect);
  v.Keys({"start", "Initial state of the vehicle, at rest."}, s.start);
  v.Keys({"hand", "Hand-held motion over the pad with the motors off, instead of a flight (Sec. VI-B.1)."}, s.hand);
  v.Items({"script", "Maneuvers to fly, in order. The list is empty if hand.carries is true."}, s.script);
  v.Items({"events", "Disturbances and changes during the flight, each at a given time."}, s.events);
  v.Items({"criteria",
           "Bounds of metrics. A flight passes if all metrics are within their bounds and the outcome is the expected "
           "one."},
          s.criteria);
  v.Check("name", [&s] {
    if (!IsPlainName(s.name))
      throw InputError("must have 1 to 100 letters, digits, _, - and . only, and not begin with - or .");
  });
  v.Check("script", [&s] {
    if (s.hand.carries && !s.script.empty()) throw InputError("must be empty if hand.carries is true");
    if (!s.hand.carries && s.script.empty()) throw InputError("must not be empty");
  });
}

/// Describes a sensor and checks that its rate divides the tick rate.
template <typename Sensor>
void DescribeSensor(ConfigVisitor& v, const models::Key& key, Sensor& sensor, const models::TimeBase& time,
                    const models::SectionFile& file = {}) {
  v.Section(key, file, [&sensor, &time](ConfigVisitor& s) {
    Describe(s, sensor);
    s.Check("", [&sensor, &time] { sensor.Validate(time); });
  });
}

template <typename... Sensor>
void DescribeLoggedSensors(SensorList<Sensor...>, ConfigVisitor& v, Scenario& s) {
  (DescribeSensor(v, {Sensor::kName, Sensor::kDoc}, std::get<typename Sensor::Config>(s.sensors), s.time), ...);
}

void DescribeSimulation(ConfigVisitor& v, Scenario& s) {
  v.Keys({"time", "Clock of the simulation."}, s.time);
  v.Keys({"vehicle", "Quadrotor, as keys or the name of a file."}, s.vehicle, models::kOrFile);
  v.Keys({"pad", "Landing pad, as keys or the name of a file."}, s.pad, models::kOrFile);
  DescribeSensor(
      v,
      {"camera",
       "Downward camera, as keys or the name of a file. The file has these keys or is a ROS camera_info file."},
      s.camera, s.time, {.allowed = true, .format = models::kCameraModelFile.format, .format_key = "model"});
  DescribeSensor(v, {"imu", "Inertial measurement unit."}, s.imu, s.time);
  DescribeLoggedSensors(LoggedSensors(), v, s);
  v.Keys({"scene", "Surroundings of the pad. The layout is random and depends on the seed."}, s.scene);
  v.Keys({"world", "Wind, tilt of the ground, and vibration."}, s.world);
}

void DescribeCalibrationKeys(ConfigVisitor& v, Calibration& c, const models::CameraModel& camera,
                             const models::Vehicle& vehicle) {
  v.OptionalKeys(
      {"camera_model", "Camera model assumed instead of camera.model, as keys or the name of a ROS camera_info file."},
      c.camera_model, camera, models::kCameraModelFile);
  v.OptionalKeys({"camera", "Camera mounting assumed instead of vehicle.camera."}, c.camera, vehicle.camera);
  v.OptionalKeys({"imu", "IMU mounting assumed instead of vehicle.imu."}, c.imu, vehicle.imu);
}

void DescribeAutopilot(ConfigVisitor& v, Scenario& s) {
  v.Keys({"estimator", "Estimator, which computes the state of the vehicle from IMU samples and frames."}, s.estimator);
  v.Keys({"attitude_estimator", "Attitude filter, which computes roll and pitch from the IMU and yaw from vision."},
         s.estimator.filters.attitude);
  v.Keys({"pose_filter", "Kalman filter of the vision position."}, s.estimator.filters.pose_filter);
  v.Keys({"controller", "Controller, which consists of guidance, position loop and attitude loop."}, s.controller);
}

}  // namespace

void Describe(ConfigVisitor& v, Start& start) {
  const models::Range room = Between(-15.0, 15.0);
  v.Boolean({"airborne",
             "Whether the vehicle starts in the air with its rotors turning. Otherwise it stands on the ground with "
             "its motors off."},
            start.airborne);
  if (start.airborne) {
    v.Vector3({"position_m", "Initial position of the body origin in W (airborne only)."}, start.position_m, kMeter,
              room);
  } else {
    v.Number({"x_m", "Initial X of the body origin in W (on the ground only)."}, start.position_m.x(), kMeter, room);
    v.Number({"y_m", "Initial Y of the body origin in W (on the ground only)."}, start.position_m.y(), kMeter, room);
  }
  v.Number(
      {"yaw_deg",
       "Initial yaw. The pad looks the same after a rotation by 180 degrees, and X of W is its axis within 90 degrees "
       "of the initial heading."},
      start.yaw_deg, models::kDegree, Between(-90.0, 90.0));
}

void Describe(ConfigVisitor& v, Criterion& criterion) {
  v.Text({"metric", "Name of the metric.", true}, criterion.metric);
  v.OptionalNumber({"min", "Smallest value that passes, in the unit of the metric."}, criterion.min, kNoUnit, kAny);
  v.OptionalNumber({"max", "Largest value that passes, in the unit of the metric."}, criterion.max, kNoUnit, kAny);
  v.Check("metric", [&criterion] {
    if (FindMetric(criterion.metric) == nullptr) throw InputError(fmt::format("unknown metric '{}'", criterion.metric));
  });
  v.Check("", [&criterion] {
    if (!criterion.min && !criterion.max) throw InputError("must have a min or a max");
    if (criterion.min && criterion.max && *criterion.min > *criterion.max)
      throw InputError("min must not be above max");
  });
}

void DescribeCalibration(ConfigVisitor& v, Scenario& s) {
  v.Section({"calibration",
             "Camera and mountings that estimator and controller assume instead of the true ones, as keys or the "
             "name of a file."},
            models::kOrFile,
            [&s](ConfigVisitor& c) { DescribeCalibrationKeys(c, s.calibration, s.camera.model, s.vehicle); });
}

void Describe(ConfigVisitor& v, Calibration& calibration) { DescribeCalibrationKeys(v, calibration, {}, {}); }

void Describe(ConfigVisitor& v, Scenario& s) {
  DescribeFlight(v, s);
  DescribeSimulation(v, s);
  DescribeCalibration(v, s);
  DescribeAutopilot(v, s);
  CheckScenario(v, s);
}

}  // namespace touchdown::runner
