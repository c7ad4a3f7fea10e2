#include "scenarios/flight/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/flight/camera_info.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const fs::path kFlights = fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights";

/// A scenario that can be flown, and what is added to it.
std::string With(const std::string& lines) {
  return "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\n" + lines;
}

std::vector<Override> Overrides(const std::vector<std::string>& set) { return {set.begin(), set.end()}; }

Scenario Parse(const std::string& text, std::vector<std::string> overrides = {}) {
  return ParseScenario(text, "f.yaml", fs::path(TOUCHDOWN_SOURCE_DIR), Overrides(overrides));
}

std::string ErrorOf(const std::string& text, std::vector<std::string> overrides = {}) {
  try {
    Parse(text, std::move(overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError for\n" << text;
  return "";
}

TEST(Scenario, ReadsTheFlightsOfTheProject) {
  for (const char* name : {"takeoff_hover_land", "disturbed_hover", "landing", "outdoor"}) {
    const Scenario scenario = LoadScenario(kFlights / (std::string(name) + ".yaml"));
    EXPECT_EQ(scenario.name, name);
    EXPECT_FALSE(scenario.criteria.empty());
  }
}

TEST(Scenario, ConvertsUnitsToSi) {
  const Scenario s = Parse(With("camera: {exposure_ms: 4, latency_ms: 30}\nstart: {yaw_deg: 30}\n"));
  EXPECT_DOUBLE_EQ(s.camera.exposure_s, 0.004);
  EXPECT_DOUBLE_EQ(s.camera.latency_s, 0.030);
  EXPECT_DOUBLE_EQ(s.start.yaw, models::kPi / 6.0);
}

TEST(Scenario, ExpectsTheEndThatItsScriptHas) {
  EXPECT_EQ(Parse(With("")).expected_outcome(), Outcome::kLanded);
  const std::string in_the_air = "script: [{do: takeoff, height_m: 1}, {do: hover, duration_s: 5}]\n";
  EXPECT_EQ(Parse(in_the_air).expected_outcome(), Outcome::kHovered);
  EXPECT_EQ(Parse(in_the_air + "expect: gave_up\n").expected_outcome(), Outcome::kGaveUp);
  EXPECT_EQ(Parse(With("expect: hovered\n")).expected_outcome(), Outcome::kHovered);
}

TEST(Scenario, KeepsWhatAnOverrideDoesNotName) {
  const Scenario s = Parse(With("camera: {noise_sigma: 5, exposure_ms: 2}\n"), {"camera.noise_sigma=7", "seed=9"});
  EXPECT_EQ(s.camera.noise_sigma, 7.0);
  EXPECT_DOUBLE_EQ(s.camera.exposure_s, 0.002);
  EXPECT_EQ(s.seed, 9u);
}

TEST(Scenario, TakesTheLastOfTwoOverrides) { EXPECT_EQ(Parse(With(""), {"seed=2", "seed=3"}).seed, 3u); }

TEST(Scenario, ChangesItemsOfListsByTheirNumber) {
  const std::string text = With("events:\n  - {at_s: 1, do: push, force_n: [1, 2, 3], duration_s: 1}\n");
  const Scenario s = Parse(text, {"events.0.force_n.1=7", "events.0.at_s=4", "script.0.height_m=2"});
  EXPECT_EQ(s.events[0].force_n, Eigen::Vector3d(1, 7, 3));
  EXPECT_EQ(s.events[0].at_s, 4.0);
  EXPECT_EQ(s.script[0].position_m.z(), 2.0);
  EXPECT_THAT(ErrorOf(text, {"events.1.at_s=4"}), HasSubstr("events.1: unknown key, the list has 1 items"));
  EXPECT_THAT(ErrorOf(text, {"events.0.force_n.3=4"}), HasSubstr("events.0.force_n.3: unknown key"));
}

TEST(Scenario, JudgesOverridesTogether) {
  EXPECT_THAT(ErrorOf(With(""), {"vehicle.mass_kg=3"}), AllOf(HasSubstr("vehicle"), HasSubstr("cannot lift")));
  EXPECT_NO_THROW(Parse(With(""), {"vehicle.mass_kg=3", "vehicle.rotor.max_speed_rad_s=1200"}));
}

TEST(Scenario, NamesFileLineAndKeyOfWhatIsWrong) {
  EXPECT_THAT(ErrorOf(With("\ncamera:\n  fps: 60\n")), StartsWith("f.yaml:6: camera.fps: unknown key"));
  EXPECT_THAT(ErrorOf(With("seed: 1\nseed: 2\n")), StartsWith("f.yaml:5: seed: duplicate key"));
  EXPECT_THAT(ErrorOf(With("camera: {noise_sigma: much}\n")),
              StartsWith("f.yaml:4: camera.noise_sigma: must be a number"));
  EXPECT_THAT(ErrorOf(With("camera: {noise_sigma: \"3\"}\n")), HasSubstr("camera.noise_sigma: must be a number"));
  EXPECT_THAT(ErrorOf(With("camera: {noise_sigma: [3]}\n")), HasSubstr("camera.noise_sigma: must be a number"));
  EXPECT_THAT(ErrorOf(With("camera: {noise_sigma: .nan}\n")), HasSubstr("camera.noise_sigma: must be a finite number"));
  EXPECT_THAT(ErrorOf(With("time_limit_s: .inf\n")), HasSubstr("time_limit_s: must be a finite number"));
  EXPECT_THAT(ErrorOf(With("time_limit_s: nan\n")), HasSubstr("time_limit_s: must be a finite number"));
  EXPECT_THAT(ErrorOf(With("time_limit_s: 1e999\n")), HasSubstr("time_limit_s: must be a finite number"));
  EXPECT_THAT(ErrorOf(With("vehicle: {mass_kg: -1.2}\n")), HasSubstr("vehicle.mass_kg: must be above 0, is -1.2"));
  EXPECT_THAT(ErrorOf(With("camera: {model: {width_px: 0}}\n")),
              HasSubstr("camera.model.width_px: must be from 1 to 16384, is 0"));
  EXPECT_THAT(ErrorOf(With("camera: {model: {width_px: 1.5}}\n")), HasSubstr("width_px: must be a whole number"));
  EXPECT_THAT(ErrorOf(With("scene: {pad: maybe}\n")), HasSubstr("scene.pad: must be true or false"));
  EXPECT_THAT(ErrorOf(With("expect: won\n")), HasSubstr("expect: must be one of landed, hovered"));
  EXPECT_THAT(ErrorOf(With("world: {wind_m_s: [1, 2]}\n")), HasSubstr("world.wind_m_s: must be a list of 3 numbers"));
  EXPECT_THAT(ErrorOf(With("camera: 3\n")), HasSubstr("camera"));
  EXPECT_THAT(ErrorOf(With("seed:\n")), StartsWith("f.yaml:4: seed: has no value"));
  EXPECT_THAT(ErrorOf(With("seed: -1\n")), HasSubstr("seed: must be at least 0"));
  EXPECT_THAT(ErrorOf(With("seed: 99999999999999999999\n")), HasSubstr("seed: is too large"));
  EXPECT_THAT(ErrorOf(With("name: ../up\n")), StartsWith("f.yaml:4: name: must be letters"));
  EXPECT_THAT(ErrorOf("seed: 1\n"), HasSubstr("script: must not be empty"));
}

TEST(Scenario, NamesTheKeyThatWasMeant) {
  EXPECT_THAT(ErrorOf(With("camera: {noise_sgima: 3}\n")), HasSubstr("did you mean noise_sigma?"));
}

constexpr const char* kMarks = R"(pad:
  marks:
    - {shape: disc, x_m: 0.02, y_m: 0.05, diameter_m: 0.01}
    - {shape: bar, x_m: -0.02, y_m: 0.05, length_m: 0.02, width_m: 0.004, angle_deg: 30}
)";

TEST(Scenario, ReadsThePadsMarks) {
  const models::PadMark disc{.shape = models::PadMark::Shape::kDisc, .centre_m = {0.02, 0.05}, .diameter_m = 0.01};
  const models::PadMark bar{.shape = models::PadMark::Shape::kBar,
                            .centre_m = {-0.02, 0.05},
                            .length_m = 0.02,
                            .width_m = 0.004,
                            .angle = 30.0 * (models::kPi / 180.0)};
  EXPECT_EQ(Parse(With(kMarks)).pad.marks, (std::vector{disc, bar}));
  EXPECT_EQ(Parse(With("")).pad.marks.size(), 0u);
  EXPECT_EQ(Parse(With(kMarks), {"pad.marks.0.x_m=0.03"}).pad.marks[0].centre_m.x(), 0.03);
}

TEST(Scenario, RefusesAMarkThatIsNoneAndNamesItsLineAndKey) {
  // What of the marks is replaced, by what, and what the error must say.
  const struct {
    std::string written, instead, error;
  } cases[] = {
      {"shape: disc", "shape: star", "f.yaml:6: pad.marks.0.shape: must be one of disc, bar, is 'star'"},
      {"shape: disc, ", "", "f.yaml:6: pad.marks.0.shape: must be given"},
      {"x_m: 0.02, ", "", "f.yaml:6: pad.marks.0.x_m: must be given"},
      {", diameter_m: 0.01", "", "f.yaml:6: pad.marks.0.diameter_m: must be given"},
      {"diameter_m: 0.01", "diameter_m: -0.01", "f.yaml:6: pad.marks.0.diameter_m: must be above 0, is -0.01"},
      {"diameter_m: 0.01", "diameter_m: 0.01, angle_deg: 3", "f.yaml:6: pad.marks.0.angle_deg: unknown key"},
      {"diameter_m: 0.01", "radius_m: 0.01", "f.yaml:6: pad.marks.0.diameter_m: must be given"},
      {"length_m: 0.02, ", "", "f.yaml:7: pad.marks.1.length_m: must be given"},
      {", width_m: 0.004", "", "f.yaml:7: pad.marks.1.width_m: must be given"},
      {"width_m: 0.004", "width_m: 0.004, diameter_m: 1", "f.yaml:7: pad.marks.1.diameter_m: unknown key"},
      {"angle_deg: 30", "angle_deg: 300", "f.yaml:7: pad.marks.1.angle_deg: must be from -180 to 180, is 300"},
      {"x_m: -0.02", "x_m: 0.06", "f.yaml:7: pad.marks.1: a pad's mark must lie wholly within its ring"},
  };
  for (const auto& [written, instead, error] : cases) {
    std::string text = kMarks;
    ASSERT_NE(text.find(written), std::string::npos) << written;
    text.replace(text.find(written), written.size(), instead);
    EXPECT_THAT(ErrorOf(With(text)), StartsWith(error));
  }
  EXPECT_THAT(ErrorOf(With("pad: {marks: 3}\n")), StartsWith("f.yaml:4: pad.marks: must be a list"));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.ring_width_m=0.032"}), StartsWith("f.yaml:6: pad.marks.0: "));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.marks.0.shape=bar"}), HasSubstr("pad.marks.0: the sizes of a pad's mark"));
  EXPECT_THAT(ErrorOf(With(kMarks), {"pad.marks.2.x_m=0"}), HasSubstr("pad.marks.2: unknown key"));
}

TEST(Scenario, ReadsASettingTheSunAndHowTheGroundLies) {
  const Scenario s =
      Parse(With("scene: {setting: outdoor, sun: {elevation_deg: 30, to_sky: 2}}\n"
                 "world: {ground_tilt_deg: [3, -4.5]}\n"));
  EXPECT_TRUE(s.scene.IsOutdoor());
  EXPECT_DOUBLE_EQ(s.scene.sun.elevation, models::kPi / 6.0);
  EXPECT_EQ(s.scene.sun.to_sky, 2.0);
  EXPECT_DOUBLE_EQ(s.world.ground_tilt.roll, models::kPi / 60.0);
  EXPECT_DOUBLE_EQ(s.world.ground_tilt.pitch, -models::kPi / 40.0);
  EXPECT_THAT(ErrorOf(With("scene: {setting: moon}\n")), HasSubstr("scene.setting: must be one of indoor, outdoor"));
  EXPECT_THAT(ErrorOf(With("scene: {sun: {elevation_deg: 5}}\n")),
              HasSubstr("scene.sun.elevation_deg: must be from 10 to 90, is 5"));
  EXPECT_THAT(ErrorOf(With("world: {ground_tilt_deg: [16, 0]}\n")),
              HasSubstr("world.ground_tilt_deg.0: must be from -15 to 15, is 16"));
  EXPECT_THAT(ErrorOf(With("world: {ground_tilt_deg: [12, 12]}\n")),
              HasSubstr("world.ground_tilt_deg: the ground must not be steeper than 15 degrees"));
}

TEST(Scenario, NamesTheOverrideThatIsWrong) {
  EXPECT_THAT(ErrorOf(With(""), {"camera.fps=60"}), StartsWith("--set camera.fps=60: camera.fps: unknown key"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.rate_hz=fast"}), HasSubstr("camera.rate_hz: must be a whole number"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.noise_sigma=.nan"}), HasSubstr("must be a finite number"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.noise_sigma="}), HasSubstr("camera.noise_sigma: has no value"));
}

TEST(Scenario, ChecksWhatKeysMeanTogether) {
  EXPECT_THAT(ErrorOf(With("\ncamera:\n  rate_hz: 7\n")), AllOf(StartsWith("f.yaml:"), HasSubstr("camera")));
  EXPECT_THAT(ErrorOf(With("time: {ticks_per_s: 1000}\n")), HasSubstr("does not divide"));
  EXPECT_THAT(ErrorOf(With("pad: {h_width_m: 0.2}\n")), StartsWith("f.yaml:4: pad: "));
  EXPECT_THAT(ErrorOf(With("estimator: {name: magic}\n")), StartsWith("f.yaml:4: estimator.name: unknown estimator"));
  EXPECT_THAT(ErrorOf(With("criteria: [{metric: flight.beauty, min: 1}]\n")),
              HasSubstr("criteria.0.metric: unknown metric"));
  EXPECT_THAT(ErrorOf(With("criteria: [{metric: flight.sim_time_s}]\n")), HasSubstr("needs a min or a max"));
  EXPECT_THAT(ErrorOf("script: [{do: hover, duration_s: 3}]\n"), StartsWith("f.yaml:1: script: "));
  EXPECT_THAT(ErrorOf("script: []\n"), HasSubstr("script"));
  EXPECT_THAT(ErrorOf("script: [{do: land}]\nhand: {carries: true}\n"), HasSubstr("script: must be empty"));
  EXPECT_THAT(ErrorOf("hand: {carries: true}\nstart: {airborne: true}\n"), HasSubstr("hand.carries: the vehicle st"));
  EXPECT_THAT(ErrorOf("hand: {carries: true, max_height_m: 9}\n"), StartsWith("f.yaml:1: hand.max_height_m: "));
  EXPECT_NO_THROW(ParseScenario("hand: {carries: true}\n", "f.yaml", {}));
  EXPECT_THAT(ErrorOf(With("camera: {latency_ms: 60}\n")),
              AllOf(StartsWith("f.yaml:4: camera.latency_ms: "), HasSubstr("controller.vision_fresh_s")));
  EXPECT_EQ(Parse(With("camera: {latency_ms: 60}\ncontroller: {vision_fresh_s: 0.08}\n")).camera.latency_s, 0.060);
}

TEST(Scenario, RefusesPlacesOutsideTheRoom) {
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, height_m: 11}]\n"),
              AllOf(StartsWith("f.yaml:1: script.0.height_m: "), HasSubstr("ceiling (10 m)")));
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, height_m: 0.1}]\n"), StartsWith("f.yaml:1: script.0.height_m: "));
  const std::string airborne = "start:\n  airborne: true\n";
  EXPECT_THAT(ErrorOf(airborne + "script:\n  - {do: hover, duration_s: 1, position_m: [0, 5.5, 1]}\n"),
              AllOf(StartsWith("f.yaml:4: script.0.position_m: 5.5 m lies outside the room")));
  EXPECT_THAT(ErrorOf(airborne + "  position_m: [-5, 0, 1]\nscript: [{do: land}]\n"),
              StartsWith("f.yaml:3: start.position_m: -5 m lies outside the room"));
  EXPECT_THAT(ErrorOf(airborne + "  position_m: [0, 0, 0]\nscript: [{do: land}]\n"),
              StartsWith("f.yaml:3: start.position_m: a height of 0 m"));
  EXPECT_THAT(ErrorOf(With("start: {x_m: 4.8}\n")), StartsWith("f.yaml:4: start.x_m: "));
  EXPECT_THAT(ErrorOf(With("start: {y_m: -4.8}\n")), StartsWith("f.yaml:4: start.y_m: "));
  EXPECT_EQ(Parse(With("start: {x_m: 4.8}\nscene: {floor_size_m: 12}\n")).start.position_m.x(), 4.8);
}

TEST(Scenario, RefusesTimesBeyondEveryFlight) {
  const std::string airborne = "start: {airborne: true}\n";
  EXPECT_THAT(ErrorOf(airborne + "script: [{do: hover, duration_s: 1e300}]\n"),
              StartsWith("f.yaml:2: script.0.duration_s: must be from 0 to 36000, is 1e300"));
  EXPECT_THAT(ErrorOf(With("time_limit_s: 1e300\n")), HasSubstr("time_limit_s: must be above 0 and at most 36000"));
  EXPECT_THAT(ErrorOf(With("events: [{at_s: 1e300, do: lose_frames, duration_s: 1}]\n")),
              HasSubstr("events.0.at_s: must be from 0 to 36000"));
  for (const ScenarioKey& key : ScenarioReference()) {
    if (key.unit == "s") {
      EXPECT_THAT(key.range, AnyOf(HasSubstr("at most"), HasSubstr(" to "))) << key.path;
    }
  }
}

TEST(Scenario, RefusesEventsWithoutEffect) {
  const auto error_of = [](const std::string& event) { return ErrorOf(With("events:\n  - {" + event + "}\n")); };
  EXPECT_THAT(error_of("at_s: 1, do: push, duration_s: 1"),
              AllOf(StartsWith("f.yaml:5: events.0: "), HasSubstr("needs a force_n or a torque_n_m other than 0")));
  EXPECT_THAT(error_of("at_s: 1, do: push, force_n: [1, 0, 0], duration_s: 1e-4"), HasSubstr("less than a tick"));
  EXPECT_THAT(error_of("at_s: 1, do: lose_frames, duration_s: 0.01"), HasSubstr("less than a camera frame's period"));
  EXPECT_THAT(error_of("at_s: 120, do: lose_frames, duration_s: 1"),
              StartsWith("f.yaml:5: events.0.at_s: must be below time_limit_s"));
  EXPECT_THAT(ErrorOf(With("scene: {pad: false}\nevents: [{at_s: 1, do: cover_pad, duration_s: 1}]\n")),
              StartsWith("f.yaml:5: events.0: there is no pad to cover"));
  EXPECT_EQ(Parse(With("events: [{at_s: 1, do: push, torque_n_m: [0, 0, 0.1], duration_s: 1}]\n")).events.size(), 1u);
}

TEST(Scenario, CannotExpectAnError) {
  EXPECT_THAT(ErrorOf(With("expect: error\n")),
              StartsWith("f.yaml:4: expect: must be one of landed, hovered, gave_up, crashed, is 'error'"));
}

TEST(Scenario, KnowsOnlyTheKeysOfAnItemsKind) {
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, duration_s: 3}]\n"), HasSubstr("script.0.duration_s: unknown key"));
  EXPECT_THAT(ErrorOf(With("events: [{at_s: 1, do: wind, duration_s: 2, velocity_m_s: [1, 0, 0]}]\n")),
              HasSubstr("events.0.duration_s: unknown key"));
  EXPECT_THAT(ErrorOf(With("events: [{do: push, duration_s: 2}]\n")), HasSubstr("events.0.at_s: must be given"));
}

TEST(Scenario, ReadsItsOwnYamlToTheSameScenario) {
  for (const char* name : {"takeoff_hover_land", "disturbed_hover", "landing", "outdoor"}) {
    const std::vector<std::string> overrides = {"start.yaw_deg=12.3456789", "camera.exposure_ms=3.3333333333333335",
                                                "imu.gyro_range_deg_s=499.99999999999994", "description=\"a: b\\n#c\""};
    const Scenario scenario = LoadScenario(kFlights / (std::string(name) + ".yaml"), Overrides(overrides));
    const std::string yaml = ScenarioYaml(scenario);
    const Scenario again = ParseScenario(yaml, "other.yaml", "");
    EXPECT_EQ(ScenarioYaml(again), yaml);
    EXPECT_EQ(again.name, name);
    EXPECT_EQ(again.start.yaw, scenario.start.yaw);
    EXPECT_EQ(again.camera.exposure_s, scenario.camera.exposure_s);
    EXPECT_EQ(again.imu.gyro_range_rad_s, scenario.imu.gyro_range_rad_s);
    EXPECT_EQ(again.controller.guidance.cone_half_angle_rad, scenario.controller.guidance.cone_half_angle_rad);
    EXPECT_EQ(again.description, scenario.description);
    EXPECT_EQ(again.vehicle.imu.misalignment.pitch, scenario.vehicle.imu.misalignment.pitch);
  }
}

TEST(Scenario, FliesDefaultsAsItWouldReadThemAgain) {
  const Scenario scenario = Parse(With(""));
  EXPECT_EQ(Parse(ScenarioYaml(scenario)).imu.gyro_range_rad_s, scenario.imu.gyro_range_rad_s);
  EXPECT_EQ(Parse(ScenarioYaml(scenario)).tracking.rotation_noise_rad, scenario.tracking.rotation_noise_rad);
}

class ScenarioWithFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void Put(const std::string& name, const std::string& content) const { std::ofstream(folder_ / name) << content; }
  Scenario Load(const std::string& lines) const {
    Put("flight.yaml", With(lines));
    return LoadScenario(folder_ / "flight.yaml");
  }
  std::string LoadError(const std::string& lines) const {
    try {
      Load(lines);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
  }
  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("scenario_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

constexpr const char* kCameraInfo = R"(image_width: 752
image_height: 480
camera_name: cam0
camera_matrix: {rows: 3, cols: 3, data: [458.654, 0, 367.215, 0.0, 457.296, 248.375, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.28340811, 0.07395907, 0.0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [458, 0, 367, 0, 0, 457, 248, 0, 0, 0, 1, 0]}
)";

TEST_F(ScenarioWithFiles, ReadsARosCalibrationBesideIt) {
  Put("camera.yaml", kCameraInfo);
  for (const char* lines : {"camera: camera.yaml\n", "camera: {model: camera.yaml, rate_hz: 30}\n"}) {
    const models::CameraModel model = Load(lines).camera.model;
    EXPECT_EQ(model.width_px, 752);
    EXPECT_EQ(model.height_px, 480);
    EXPECT_EQ(model.fx_px, 458.654);
    EXPECT_EQ(model.fy_px, 457.296);
    EXPECT_EQ(model.cx_px, 367.215);
    EXPECT_EQ(model.cy_px, 248.375);
    EXPECT_EQ(model.k1, -0.28340811);
    EXPECT_EQ(model.k2, 0.07395907);
    EXPECT_EQ(LoadCameraModel(folder_ / "camera.yaml"), model);
  }
}

TEST_F(ScenarioWithFiles, ReadsAllFiveDistortionTermsAndWritesThemBack) {
  std::string text = kCameraInfo;
  text.replace(text.find("0.0, 0, 0]"), 10, "1e-4, -2e-4, 0.003]");
  Put("camera.yaml", text);
  const models::CameraModel model = LoadCameraModel(folder_ / "camera.yaml");
  EXPECT_EQ(model.p1, 1e-4);
  EXPECT_EQ(model.p2, -2e-4);
  EXPECT_EQ(model.k3, 0.003);
  Put("again.yaml", CameraInfoYaml(model, "cam0"));
  EXPECT_EQ(LoadCameraModel(folder_ / "again.yaml"), model);
}

TEST_F(ScenarioWithFiles, RefusesACalibrationThatIsNotOneAndNamesItsLineAndKey) {
  // What of the calibration is replaced, by what, and what the error must say of the calibration's file.
  const struct {
    std::string written, instead, error;
  } cases[] = {
      {"plumb_bob", "equidistant", "camera.yaml:5: distortion_model: must be plumb_bob, is 'equidistant'"},
      {"camera_name: cam0", "camera_nmae: cam0", "camera.yaml:3: camera_nmae: unknown key, did you mean camera_name?"},
      {"rows: 3, cols: 3, data: [458", "rows: 3, skew: 0, cols: 3, data: [458",
       "camera.yaml:4: camera_matrix.skew: unknown key"},
      {"image_width: 752", "image_width: 752.5", "camera.yaml:1: image_width: must be a whole number"},
      {"image_width: 752", "image_width: 0", "camera.yaml:1: image_width: must be from 1 to 16384"},
      {"image_width: 752", "", "image_width: must be given"},
      {"data: [458.654", "data: [wide", "camera.yaml:4: camera_matrix.data.0: must be a number, is 'wide'"},
      {"data: [458.654", "data: [-458.654",
       "camera.yaml:4: camera_matrix.data: must be [fx, 0, cx, 0, fy, cy, 0, 0, 1]"},
      {"data: [458.654, 0,", "data: [458.654, 2,", "camera.yaml:4: camera_matrix.data: must be [fx, 0, cx"},
      {"data: [458.654, 0,", "data: [458.654,", "camera.yaml:4: camera_matrix.data: must be a list of 9 numbers"},
      {"rows: 3, cols: 3, data: [458", "rows: 2, cols: 3, data: [458",
       "camera.yaml:4: camera_matrix.rows: must be 3, is 2"},
      {"rows: 3, cols: 3, data: [458", "cols: 3, data: [458", "camera.yaml:4: camera_matrix.rows: must be given"},
      {"rows: 1, cols: 5", "rows: 1, cols: 4",
       "camera.yaml:6: distortion_coefficients.data: must be a list of 4 numbers"},
      {"rows: 1, cols: 5", "rows: 1, cols: 8", "camera.yaml:6: distortion_coefficients.cols: must be from 4 to 5"},
      {"-0.28340811", "-0.9", "camera.yaml:6: distortion_coefficients.data: the camera's distortion folds"},
      {"data: [1, 0, 0,", "data: [1, 0.1, 0,", "camera.yaml:7: rectification_matrix.data: must be [1, 0, 0"},
      {"367, 0, 0, 457", "367, -50, 0, 457", "camera.yaml:8: projection_matrix.data: must be [fx', 0, cx', 0,"},
      {"rows: 3, cols: 4", "rows: 3, cols: 3", "camera.yaml:8: projection_matrix.cols: must be 4, is 3"},
  };
  for (const auto& [written, instead, error] : cases) {
    std::string text = kCameraInfo;
    ASSERT_NE(text.find(written), std::string::npos) << written;
    text.replace(text.find(written), written.size(), instead);
    Put("camera.yaml", text);
    EXPECT_THAT(LoadError("camera: camera.yaml\n"), AllOf(HasSubstr("flight.yaml:4: camera: "), HasSubstr(error)));
  }
}

TEST_F(ScenarioWithFiles, ReadsPadAndVehicleBesideItAndResolvesThemInPlace) {
  Put("pad.yaml", "outer_radius_m: 0.08\n");
  Put("heavy.yaml", "mass_kg: 1.5\n");
  const Scenario scenario = Load("pad: pad.yaml\nvehicle: heavy.yaml\n");
  EXPECT_EQ(scenario.pad.outer_radius_m, 0.08);
  EXPECT_EQ(scenario.vehicle.mass_kg, 1.5);
  EXPECT_EQ(LoadPad(folder_ / "pad.yaml"), scenario.pad);
  EXPECT_EQ(ParseScenario(ScenarioYaml(scenario), "f", "/nowhere").pad, scenario.pad);
}

TEST_F(ScenarioWithFiles, WritesAPadsMarksAsItReadsThem) {
  const models::LandingPad pad = Parse(With(kMarks), {"pad.marks.1.angle_deg=-12.345678901234567"}).pad;
  Put("pad.yaml", PadYaml(pad));
  EXPECT_EQ(LoadPad(folder_ / "pad.yaml"), pad);
  const Scenario scenario = Load("pad: pad.yaml\n");
  EXPECT_EQ(scenario.pad, pad);
  EXPECT_EQ(ParseScenario(ScenarioYaml(scenario), "f", "/nowhere").pad, pad);
}

TEST(ScenariosCalibration, IsTheTruthWhereItIsLeftOut) {
  const Scenario plain = Parse(With("vehicle: {camera: {misalignment_deg: [1, 2, 3]}}\n"));
  EXPECT_EQ(plain.assumed_camera(), plain.camera.model);
  EXPECT_EQ(plain.assumed_vehicle().X_BC().matrix(), plain.vehicle.X_BC().matrix());
  EXPECT_EQ(plain.assumed_vehicle().X_BU().matrix(), plain.vehicle.X_BU().matrix());
  EXPECT_THAT(ScenarioYaml(plain), Not(HasSubstr("calibration"))) << "a resolved scenario follows its truth";
  EXPECT_NO_THROW(Parse(With("calibration: {}\n")));

  const Scenario partly =
      Parse(With("calibration: {camera: {misalignment_deg: [4, 5, 6]}, camera_model: {fx_px: 321}}\n"),
            {"vehicle.camera.position_m=[0.1, 0, -0.02]", "camera.model.k1=-0.12"});
  EXPECT_EQ(partly.calibration.camera->position_m, Eigen::Vector3d(0.1, 0.0, -0.02)) << "the truth, as overridden";
  EXPECT_EQ(partly.assumed_camera().fx_px, 321.0);
  EXPECT_EQ(partly.assumed_camera().k1, -0.12);
  EXPECT_EQ(partly.camera.model.fx_px, 320.0) << "the truth stays";
  EXPECT_FALSE(partly.calibration.imu);
}

TEST(ScenariosCalibration, IsReadAgainFromItsOwnYamlToTheLastBit) {
  const Scenario scenario =
      Parse(With("calibration: {camera: {misalignment_deg: [1.2345678901234567, 0.1, 3]}, imu: {misalignment_deg: "
                 "[0.3, 0.7, 1]}}\n"),
            {"calibration.camera_model.k2=0.012345678901234567", "calibration.imu.misalignment_deg.2=-1.1"});
  const std::string yaml = ScenarioYaml(scenario);
  const Scenario again = ParseScenario(yaml, "f", "/nowhere");
  EXPECT_EQ(ScenarioYaml(again), yaml);
  EXPECT_EQ(again.assumed_camera(), scenario.assumed_camera());
  EXPECT_EQ(again.assumed_vehicle().X_BC().matrix(), scenario.assumed_vehicle().X_BC().matrix());
  EXPECT_EQ(again.assumed_vehicle().X_BU().matrix(), scenario.assumed_vehicle().X_BU().matrix());
  EXPECT_DOUBLE_EQ(again.calibration.imu->misalignment.yaw, models::DegToRad(-1.1));
}

TEST(ScenariosCalibration, NamesWhatIsWrong) {
  EXPECT_THAT(ErrorOf(With("calibration: {lens: 3}\n")), StartsWith("f.yaml:4: calibration.lens: unknown key"));
  EXPECT_THAT(ErrorOf(With("calibration: {imu: {yaw: 3}}\n")), HasSubstr("calibration.imu.yaw: unknown key"));
  EXPECT_THAT(ErrorOf(With("calibration: {camera_model: {width_px: 320}}\n")),
              StartsWith("f.yaml:4: calibration.camera_model: is for 320 x 480 px, but the camera's images have"));
  EXPECT_THAT(ErrorOf(With("calibration: {camera: {position_m: [0, 0, -1]}}\n")),
              StartsWith("f.yaml:4: calibration.camera: the vehicle's camera must sit above its feet"));
}

TEST_F(ScenarioWithFiles, ReadsACalibrationBesideItAndARosOneWithinIt) {
  std::string camera = kCameraInfo;
  Put("camera.yaml", camera);
  Put("calibration.yaml", "camera_model: camera.yaml\nimu: {misalignment_deg: [1, 0, 0]}\n");
  const Scenario scenario = Load("calibration: calibration.yaml\ncamera: {model: {width_px: 752, cx_px: 375.5}}\n");
  EXPECT_EQ(scenario.assumed_camera(), LoadCameraModel(folder_ / "camera.yaml"));
  EXPECT_NE(scenario.camera.model.fx_px, 458.654);
  EXPECT_DOUBLE_EQ(scenario.assumed_vehicle().imu.misalignment.roll, models::DegToRad(1.0));
  Put("again.yaml", CalibrationYaml(LoadCalibration(folder_ / "calibration.yaml")));
  EXPECT_EQ(CalibrationYaml(LoadCalibration(folder_ / "again.yaml")),
            CalibrationYaml(LoadCalibration(folder_ / "calibration.yaml")));
}

TEST_F(ScenarioWithFiles, NamesTheFileAndTheKeyThatNamedIt) {
  EXPECT_THAT(LoadError("pad: none.yaml\n"),
              AllOf(HasSubstr("flight.yaml:4: pad: "), HasSubstr("none.yaml: no such file")));
  Put("pad.yaml", "\nradius: 1\n");
  EXPECT_THAT(LoadError("pad: pad.yaml\n"), HasSubstr("pad.yaml:2: pad.radius: unknown key"));
  Put("pad.yaml", "marks:\n  - shape: disc\n    x_m: 0.07\n    y_m: 0\n    diameter_m: 0.01\n");
  EXPECT_THAT(LoadError("pad: pad.yaml\n"), HasSubstr("pad.yaml:2: pad.marks.0: a pad's mark must lie wholly"));
}

TEST(ScenarioReference, ListsKeysOfEveryKind) {
  const std::vector<ScenarioKey> reference = ScenarioReference();
  const auto has = [](const char* path, const char* unit, const char* value) {
    return Contains(AllOf(Field(&ScenarioKey::path, path), Field(&ScenarioKey::unit, unit),
                          Field(&ScenarioKey::default_value, value)));
  };
  EXPECT_THAT(reference, has("camera.exposure_ms", "ms", "4"));
  EXPECT_THAT(reference, has("camera.model.width_px", "px", "640"));
  EXPECT_THAT(reference, has("events.N.force_n", "N", "[0, 0, 0]"));
  EXPECT_THAT(reference, has("events.N.velocity_m_s", "m/s", "required"));
  EXPECT_THAT(reference, has("script.N.duration_s", "s", "required"));
  EXPECT_THAT(reference, has("start.position_m", "m", "[0, 0, 1]"));
  EXPECT_THAT(reference, has("start.x_m", "m", "0"));
  EXPECT_THAT(reference, has("estimator.contour_points", "-", "subpixel"));
  EXPECT_THAT(reference, has("scene.pad", "-", "true"));
  EXPECT_THAT(reference, has("pad.marks.N.diameter_m", "m", "required"));
  EXPECT_THAT(reference, has("pad.marks.N.angle_deg", "deg", "0"));
  for (const ScenarioKey& key : reference) EXPECT_THAT(key.doc, EndsWith(".")) << key.path;
}

}  // namespace
}  // namespace touchdown::scenarios
