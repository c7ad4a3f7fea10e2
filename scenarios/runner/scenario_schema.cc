#include "scenarios/runner/scenario_schema.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/config/camera_info.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario_checks.h"

namespace touchdown::config {

using namespace runner;
namespace {

constexpr std::array<std::string_view, 3> kManoeuvreNames = {"takeoff", "hover", "land"};

/// A flight that ends in an error has no verdict but that: nothing can expect it.
constexpr auto kExpectableOutcomes = std::span(kOutcomeNames).first<4>();
static_assert(kOutcomeNames[4] == "error");

bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name[0] != '.' && name[0] != '-' &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                  c == '.';
         });
}

}  // namespace

void Describe(ConfigVisitor& v, Start& start) {
  v.Boolean({"airborne", "Starts in the air with its rotors turning; otherwise on its feet."}, start.airborne);
  if (start.airborne) {
    v.Vector3({"position_m", "Of the body's origin in W (airborne only)."}, start.position_m, kMetre,
              Between(-15.0, 15.0));
  } else {
    v.Number({"x_m", "Of the body's origin in W (on its feet only)."}, start.position_m.x(), kMetre,
             Between(-15.0, 15.0));
    v.Number({"y_m", "Of the body's origin in W (on its feet only)."}, start.position_m.y(), kMetre,
             Between(-15.0, 15.0));
  }
  v.Number({"yaw_deg", "Heading. W's X lies on its side, so it is at most 90."}, start.yaw, kDegree,
           Between(-90.0, 90.0));
}

void Describe(ConfigVisitor& v, controller::Manoeuvre& m) {
  v.Choice({"do", "What to do.", true}, m.kind, kManoeuvreNames);
  switch (m.kind) {
    case controller::ManoeuvreKind::kTakeoff:
      v.Number({"height_m", "Of the body's origin above the pad at the end (takeoff only)."}, m.position_m.z(), kMetre,
               PositiveUpTo(20.0));
      break;
    case controller::ManoeuvreKind::kHover:
      v.Vector3({"position_m", "Set-point in W (hover only)."}, m.position_m, kMetre, Between(-15.0, 15.0));
      v.Number({"duration_s", "How long to stay there (hover only).", true}, m.duration_s, kSecond, kTime);
      break;
    case controller::ManoeuvreKind::kLand:
      break;
  }
}

void Describe(ConfigVisitor& v, Event& event) {
  v.Number({"at_s", "When it begins, from the start of the flight.", true}, event.at_s, kSecond, kTime);
  v.Choice({"do", "What happens.", true}, event.kind, Event::kNames);
  switch (event.kind) {
    case Event::Kind::kPush:
      v.Vector3({"force_n", "In W, at the body's origin (push only)."}, event.force_n, kNewton, Between(-1e3, 1e3));
      v.Vector3({"torque_n_m", "In W (push only)."}, event.torque_n_m, {"Nm"}, Between(-1e3, 1e3));
      break;
    case Event::Kind::kWind:
      v.Vector3({"velocity_m_s", "Of the mean wind in W from then on (wind only).", true}, event.velocity_m_s,
                kMetrePerSecond, Between(-50.0, 50.0));
      return;
    case Event::Kind::kCoverPad:
    case Event::Kind::kLoseFrames:
      break;
  }
  v.Number({"duration_s", "How long it lasts (not for wind).", true}, event.duration_s, kSecond, kPositiveTime);
}

void Describe(ConfigVisitor& v, Criterion& criterion) {
  v.Text({"metric", "Name of the metric.", true}, criterion.metric);
  v.OptionalNumber({"min", "It must be at least this, in the unit of its name."}, criterion.min, kNoUnit, kAny);
  v.OptionalNumber({"max", "It must be at most this."}, criterion.max, kNoUnit, kAny);
  v.Check("metric", [&criterion] {
    if (FindMetric(criterion.metric) == nullptr) throw InputError(fmt::format("unknown metric '{}'", criterion.metric));
  });
  v.Check("", [&criterion] {
    if (!criterion.min && !criterion.max) throw InputError("needs a min or a max");
    if (criterion.min && criterion.max && *criterion.min > *criterion.max) throw InputError("its min is over its max");
  });
}

namespace {

void DescribeStory(ConfigVisitor& v, Scenario& s) {
  v.Text({"name", "Letters, digits, _ - and . only; by default the file's name."}, s.name);
  v.Text({"description", "What the flight shows."}, s.description);
  v.Integer({"seed", "Of every random source."}, s.seed, kNotNegative);
  v.Number({"time_limit_s", "After which the flight counts as given up."}, s.time_limit_s, kSecond, kPositiveTime);
  int expect = s.expect ? static_cast<int>(*s.expect) : -1;
  v.Choice({"expect", "The right end of the flight; by default as the script ends."}, expect, kExpectableOutcomes);
  if (expect >= 0) s.expect = static_cast<Outcome>(expect);
  v.Keys({"start", "Where the vehicle is at the start, at rest."}, s.start);
  v.Keys({"hand", "Carries the vehicle around over the pad, motors off, in place of a flight (Sec. VI-B.1)."}, s.hand);
  v.Items({"script", "What the vehicle is to do, one after the other; nothing when a hand carries it."}, s.script);
  v.Items({"events", "What happens to it meanwhile."}, s.events);
  v.Items({"criteria", "What the flight must keep to pass, beside ending as expected."}, s.criteria);
  v.Check("name", [&s] {
    if (!IsPlainName(s.name)) throw InputError("must be letters, digits, _, - and . only");
  });
  v.Check("script", [&s] {
    if (s.hand.carries && !s.script.empty()) throw InputError("must be empty: hand.carries is true");
    if (!s.hand.carries && s.script.empty()) throw InputError("must not be empty");
  });
}

void DescribeSimulation(ConfigVisitor& v, Scenario& s) {
  v.Section({"time", "The simulation's clock."}, {}, [&s](ConfigVisitor& t) {
    t.Integer({"ticks_per_s", "Physics steps a second; every sensor's rate divides it."}, s.time.ticks_per_s,
              Between(100, 100000));
  });
  v.KeysOrFile({"vehicle", "The quadrotor: in place, or the name of a file."}, s.vehicle);
  v.KeysOrFile({"pad", "The landing pad: in place, or the name of a file."}, s.pad);
  v.Section(
      {"camera", "The downward camera: in place, or the name of a file with these keys or of a ROS camera_info file."},
      {true,
       [](ConfigNode root) {
         if (!IsCameraInfo(root)) return root;
         ConfigNode camera;
         camera.kind = ConfigNode::Kind::kKeys;
         camera.origin = root.origin;
         camera.keys.push_back({"model", CameraModelFromCameraInfo(root)});
         return camera;
       }},
      [&s](ConfigVisitor& c) { DescribeCamera(c, s.camera, s.time); });
  v.Section({"imu", "The inertial measurement unit."}, {}, [&s](ConfigVisitor& i) {
    Describe(i, s.imu);
    i.Check("", [&s] { s.imu.Validate(s.time); });
  });
  v.Section({"tracking", "The external tracking system, whose word goes to tracking.csv."}, {}, [&s](ConfigVisitor& t) {
    Describe(t, s.tracking);
    t.Check("", [&s] { s.tracking.Validate(s.time); });
  });
  v.Keys({"scene", "What lies around the pad. The layout is drawn from the seed."}, s.scene);
  v.Keys({"world", "Wind, vibration, and how the ground lies."}, s.world);
  v.Section(
      {"calibration",
       "What estimator and autopilot are told of the sensors, and is the truth where it is left out: in place, or "
       "the name of a file."},
      {.allowed = true, .translate = nullptr},
      [&s](ConfigVisitor& c) { DescribeCalibration(c, s.calibration, s.camera.model, s.vehicle); });
}

void DescribeAutopilot(ConfigVisitor& v, Scenario& s) {
  v.Keys({"estimator", "Frames to poses."}, s.estimator);
  v.Keys({"attitude_estimator", "Roll and pitch from the IMU, yaw from vision."}, s.estimator.filters.attitude);
  v.Keys({"pose_filter", "The Kalman filter on vision's position."}, s.estimator.filters.pose_filter);
  v.Keys({"controller", "Guidance, position loop, attitude loop."}, s.controller);
}

}  // namespace

void Describe(ConfigVisitor& v, Scenario& s) {
  DescribeStory(v, s);
  DescribeSimulation(v, s);
  DescribeAutopilot(v, s);
  CheckScenario(v, s);
}

}  // namespace touchdown::config
