#include "scenarios/runner/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "models/error.h"
#include "tests/support/scenario_text.h"

namespace touchdown::runner {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using tests::ErrorOf;
using tests::Overrides;
using tests::Parse;
using tests::With;

const fs::path kFlights = fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights";

TEST(Scenario, ReadsScenariosOfTheProject) {
  for (const char* name :
       {"takeoff_hover_land", "disturbed_hover", "hand_held", "landing", "outdoor", "rectangle_pad"}) {
    const Scenario scenario = LoadScenario(kFlights / (std::string(name) + ".yaml"));
    EXPECT_EQ(scenario.name, name);
    EXPECT_FALSE(scenario.criteria.empty());
  }
}

TEST(Scenario, StoresNumbersInUnitsOfTheirKeys) {
  const Scenario s = Parse(With("camera: {exposure_ms: 4, latency_ms: 30}\nstart: {yaw_deg: 30}\n"));
  EXPECT_EQ(s.camera.exposure_ms, 4.0);
  EXPECT_EQ(s.camera.exposure_s(), 0.004);
  EXPECT_EQ(s.camera.latency_ms, 30.0);
  EXPECT_EQ(s.start.yaw_deg, 30.0);
}

TEST(Scenario, DerivesExpectedOutcomeFromScript) {
  EXPECT_EQ(Parse(With("")).expected_outcome(), Outcome::kLanded);
  const std::string in_the_air = "script: [{do: takeoff, height_m: 1}, {do: hover, duration_s: 5}]\n";
  EXPECT_EQ(Parse(in_the_air).expected_outcome(), Outcome::kHovered);
  EXPECT_EQ(Parse(in_the_air + "expect: gave_up\n").expected_outcome(), Outcome::kGaveUp);
  EXPECT_EQ(Parse(With("expect: hovered\n")).expected_outcome(), Outcome::kHovered);
}

TEST(Scenario, KeepsValuesThatAreNotOverridden) {
  const Scenario s = Parse(With("camera: {noise_sigma: 5, exposure_ms: 2}\n"), {"camera.noise_sigma=7", "seed=9"});
  EXPECT_EQ(s.camera.noise_sigma, 7.0);
  EXPECT_EQ(s.camera.exposure_ms, 2.0);
  EXPECT_EQ(s.seed, 9u);
}

TEST(Scenario, UsesLastOverride) { EXPECT_EQ(Parse(With(""), {"seed=2", "seed=3"}).seed, 3u); }

TEST(Scenario, OverridesListItemsByIndex) {
  const std::string text = With("events:\n  - {at_s: 1, do: push, force_n: [1, 2, 3], duration_s: 1}\n");
  const Scenario s = Parse(text, {"events.0.force_n.1=7", "events.0.at_s=4", "script.0.height_m=2"});
  EXPECT_EQ(std::get<Push>(s.events[0].kind).force_n, Eigen::Vector3d(1, 7, 3));
  EXPECT_EQ(s.events[0].at_s, 4.0);
  EXPECT_EQ(s.script[0].position_m.z(), 2.0);
  EXPECT_THAT(ErrorOf(text, {"events.1.at_s=4"}), HasSubstr("events.1: unknown key; the list has 1 items"));
  EXPECT_THAT(ErrorOf(text, {"events.0.force_n.3=4"}), HasSubstr("events.0.force_n.3: unknown key"));
}

TEST(Scenario, ChecksOverridesTogether) {
  EXPECT_THAT(ErrorOf(With(""), {"vehicle.mass_kg=3"}), AllOf(HasSubstr("vehicle"), HasSubstr("cannot lift")));
  EXPECT_NO_THROW(Parse(With(""), {"vehicle.mass_kg=3", "vehicle.rotor.max_speed_rad_s=1200"}));
}

TEST(Scenario, ReportsFileLineAndKeyOfErrors) {
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
  EXPECT_THAT(ErrorOf(With("camera: {model: {width_px: 1.5}}\n")), HasSubstr("width_px: must be an integer"));
  EXPECT_THAT(ErrorOf(With("scene: {pad: maybe}\n")), HasSubstr("scene.pad: must be true or false"));
  EXPECT_THAT(ErrorOf(With("expect: won\n")), HasSubstr("expect: must be one of landed, hovered"));
  EXPECT_THAT(ErrorOf(With("world: {wind_m_s: [1, 2]}\n")), HasSubstr("world.wind_m_s: must be a list of 3 numbers"));
  EXPECT_THAT(ErrorOf(With("camera: 3\n")), HasSubstr("camera"));
  EXPECT_THAT(ErrorOf(With("seed:\n")), StartsWith("f.yaml:4: seed: has no value"));
  EXPECT_THAT(ErrorOf(With("seed: -1\n")), HasSubstr("seed: must be at least 0"));
  EXPECT_THAT(ErrorOf(With("seed: 99999999999999999999\n")), HasSubstr("seed: is too large"));
  EXPECT_THAT(ErrorOf(With("name: ../up\n")), StartsWith("f.yaml:4: name: must have 1 to 100 letters"));
  EXPECT_THAT(ErrorOf("seed: 1\n"), HasSubstr("script: must not be empty"));
}

TEST(Scenario, SuggestsSimilarKey) {
  EXPECT_THAT(ErrorOf(With("camera: {noise_sgima: 3}\n")), HasSubstr("did you mean noise_sigma?"));
}

TEST(Scenario, ReadsSettingSunAndGroundTilt) {
  const Scenario s =
      Parse(With("scene: {setting: outdoor, sun: {elevation_deg: 30, to_sky: 2}}\n"
                 "world: {ground_tilt_deg: [3, -4.5]}\n"));
  EXPECT_TRUE(s.scene.IsOutdoor());
  EXPECT_EQ(s.scene.sun.elevation_deg, 30.0);
  EXPECT_EQ(s.scene.sun.to_sky, 2.0);
  EXPECT_EQ(s.world.ground_tilt.roll_deg, 3.0);
  EXPECT_EQ(s.world.ground_tilt.pitch_deg, -4.5);
  EXPECT_THAT(ErrorOf(With("scene: {setting: moon}\n")), HasSubstr("scene.setting: must be one of indoor, outdoor"));
  EXPECT_THAT(ErrorOf(With("scene: {sun: {elevation_deg: 5}}\n")),
              HasSubstr("scene.sun.elevation_deg: must be from 10 to 90, is 5"));
  EXPECT_THAT(ErrorOf(With("world: {ground_tilt_deg: [16, 0]}\n")),
              HasSubstr("world.ground_tilt_deg.0: must be from -15 to 15, is 16"));
  EXPECT_THAT(ErrorOf(With("world: {ground_tilt_deg: [12, 12]}\n")),
              HasSubstr("world.ground_tilt_deg: the ground must not be steeper than 15 degrees"));
}

TEST(Scenario, ReportsInvalidOverride) {
  EXPECT_THAT(ErrorOf(With(""), {"camera.fps=60"}), StartsWith("--set camera.fps=60: camera.fps: unknown key"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.rate_hz=fast"}), HasSubstr("camera.rate_hz: must be an integer"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.noise_sigma=.nan"}), HasSubstr("must be a finite number"));
  EXPECT_THAT(ErrorOf(With(""), {"camera.noise_sigma="}), HasSubstr("camera.noise_sigma: has no value"));
}

TEST(Scenario, ChecksKeysTogether) {
  EXPECT_THAT(ErrorOf(With("\ncamera:\n  rate_hz: 7\n")), AllOf(StartsWith("f.yaml:"), HasSubstr("camera")));
  EXPECT_THAT(ErrorOf(With("time: {ticks_per_s: 1000}\n")), HasSubstr("does not divide"));
  EXPECT_THAT(ErrorOf(With("pad: {h_width_m: 0.2}\n")), StartsWith("f.yaml:4: pad: "));
  EXPECT_THAT(ErrorOf(With("estimator: {name: magic}\n")), StartsWith("f.yaml:4: estimator.name: unknown estimator"));
  EXPECT_THAT(ErrorOf(With("criteria: [{metric: flight.beauty, min: 1}]\n")),
              HasSubstr("criteria.0.metric: unknown metric"));
  EXPECT_THAT(ErrorOf(With("criteria: [{metric: flight.sim_time_s}]\n")), HasSubstr("must have a min or a max"));
  EXPECT_THAT(ErrorOf("script: [{do: hover, duration_s: 3}]\n"), StartsWith("f.yaml:1: script: "));
  EXPECT_THAT(ErrorOf("script: []\n"), HasSubstr("script"));
  EXPECT_THAT(ErrorOf("script: [{do: land}]\nhand: {carries: true}\n"), HasSubstr("script: must be empty"));
  EXPECT_THAT(ErrorOf("hand: {carries: true}\nstart: {airborne: true}\n"), HasSubstr("hand.carries: cannot be true"));
  EXPECT_THAT(ErrorOf("hand: {carries: true, max_height_m: 9}\n"), StartsWith("f.yaml:1: hand.max_height_m: "));
  EXPECT_NO_THROW(ParseScenario("hand: {carries: true}\n", "f.yaml", {}));
  EXPECT_THAT(ErrorOf(With("camera: {latency_ms: 60}\n")),
              AllOf(StartsWith("f.yaml:4: camera.latency_ms: "), HasSubstr("controller.vision_fresh_s")));
  EXPECT_EQ(Parse(With("camera: {latency_ms: 60}\ncontroller: {vision_fresh_s: 0.08}\n")).camera.latency_ms, 60.0);
}

TEST(Scenario, RejectsPositionsOutsideRoom) {
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, height_m: 11}]\n"),
              AllOf(StartsWith("f.yaml:1: script.0.height_m: "), HasSubstr("10 m (ceiling)")));
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, height_m: 0.1}]\n"), StartsWith("f.yaml:1: script.0.height_m: "));
  const std::string airborne = "start:\n  airborne: true\n";
  EXPECT_THAT(ErrorOf(airborne + "script:\n  - {do: hover, duration_s: 1, position_m: [0, 5.5, 1]}\n"),
              AllOf(StartsWith("f.yaml:4: script.0.position_m: 5.5 m is outside the room")));
  EXPECT_THAT(ErrorOf(airborne + "  position_m: [-5, 0, 1]\nscript: [{do: land}]\n"),
              StartsWith("f.yaml:3: start.position_m: -5 m is outside the room"));
  EXPECT_THAT(ErrorOf(airborne + "  position_m: [0, 0, 0]\nscript: [{do: land}]\n"),
              StartsWith("f.yaml:3: start.position_m: the height is 0 m"));
  EXPECT_THAT(ErrorOf(With("start: {x_m: 4.8}\n")), StartsWith("f.yaml:4: start.x_m: "));
  EXPECT_THAT(ErrorOf(With("start: {y_m: -4.8}\n")), StartsWith("f.yaml:4: start.y_m: "));
  EXPECT_EQ(Parse(With("start: {x_m: 4.8}\nscene: {floor_size_m: 12}\n")).start.position_m.x(), 4.8);
}

TEST(Scenario, RejectsTooLargeTimes) {
  const std::string airborne = "start: {airborne: true}\n";
  EXPECT_THAT(ErrorOf(airborne + "script: [{do: hover, duration_s: 1e300}]\n"),
              StartsWith("f.yaml:2: script.0.duration_s: must be from 0 to 36000, is 1e300"));
  EXPECT_THAT(ErrorOf(With("time_limit_s: 1e300\n")), HasSubstr("time_limit_s: must be above 0 and at most 36000"));
  EXPECT_THAT(ErrorOf(With("events: [{at_s: 1e300, do: lose_frames, duration_s: 1}]\n")),
              HasSubstr("events.0.at_s: must be from 0 to 36000"));
  for (const config::KeyRow& key : ScenarioReference()) {
    if (key.unit == "s") {
      EXPECT_THAT(key.range, AnyOf(HasSubstr("at most"), HasSubstr(" to "))) << key.path;
    }
  }
}

TEST(Scenario, RejectsEventsWithoutEffect) {
  const auto error_of = [](const std::string& event) { return ErrorOf(With("events:\n  - {" + event + "}\n")); };
  EXPECT_THAT(error_of("at_s: 1, do: push, duration_s: 1"),
              AllOf(StartsWith("f.yaml:5: events.0: "), HasSubstr("needs a force_n or a torque_n_m other than 0")));
  EXPECT_THAT(error_of("at_s: 1, do: push, force_n: [1, 0, 0], duration_s: 1e-4"), HasSubstr("less than a tick"));
  EXPECT_THAT(error_of("at_s: 1, do: gust, peak_velocity_m_s: [0, 0, 0], duration_s: 1"),
              StartsWith("f.yaml:5: events.0: a gust needs a peak_velocity_m_s other than 0"));
  EXPECT_THAT(error_of("at_s: 1, do: gust, peak_velocity_m_s: [1, 0, 0], duration_s: 1e-3"),
              HasSubstr("less than two ticks"));
  EXPECT_THAT(error_of("at_s: 1, do: lose_frames, duration_s: 0.01"),
              HasSubstr("shorter than the frame period of the camera"));
  EXPECT_THAT(error_of("at_s: 120, do: lose_frames, duration_s: 1"),
              StartsWith("f.yaml:5: events.0.at_s: must be below time_limit_s"));
  EXPECT_THAT(ErrorOf(With("scene: {pad: false}\nevents: [{at_s: 1, do: cover_pad, duration_s: 1}]\n")),
              StartsWith("f.yaml:5: events.0: there is no pad to cover"));
  EXPECT_EQ(Parse(With("events: [{at_s: 1, do: push, torque_n_m: [0, 0, 0.1], duration_s: 1}]\n")).events.size(), 1u);
}

TEST(Scenario, CannotExpectError) {
  EXPECT_THAT(ErrorOf(With("expect: error\n")),
              StartsWith("f.yaml:4: expect: must be one of landed, hovered, gave_up, crashed, is 'error'"));
}

TEST(Scenario, AcceptsOnlyKeysOfItemKind) {
  EXPECT_THAT(ErrorOf("script: [{do: takeoff, duration_s: 3}]\n"), HasSubstr("script.0.duration_s: unknown key"));
  EXPECT_THAT(ErrorOf(With("events: [{at_s: 1, do: wind, duration_s: 2, velocity_m_s: [1, 0, 0]}]\n")),
              HasSubstr("events.0.duration_s: unknown key"));
  EXPECT_THAT(ErrorOf(With("events: [{do: push, duration_s: 2}]\n")), HasSubstr("events.0.at_s: must be given"));
}

TEST(Scenario, ReadsBackFromItsYaml) {
  for (const char* name :
       {"takeoff_hover_land", "disturbed_hover", "hand_held", "landing", "outdoor", "rectangle_pad"}) {
    const std::vector<std::string> overrides = {"start.yaw_deg=12.3456789", "camera.exposure_ms=3.3333333333333335",
                                                "imu.gyro_range_deg_s=499.99999999999994", "description=\"a: b\\n#c\""};
    const Scenario scenario = LoadScenario(kFlights / (std::string(name) + ".yaml"), Overrides(overrides));
    const std::string yaml = ScenarioYaml(scenario);
    const Scenario again = ParseScenario(yaml, "other.yaml", "");
    EXPECT_EQ(ScenarioYaml(again), yaml);
    EXPECT_EQ(again.name, name);
    EXPECT_EQ(again.start.yaw_deg, 12.3456789);
    EXPECT_EQ(again.camera.exposure_ms, 3.3333333333333335);
    EXPECT_EQ(again.imu.gyro_range_deg_s, 499.99999999999994);
    EXPECT_EQ(again.controller.guidance.cone_half_angle_deg, scenario.controller.guidance.cone_half_angle_deg);
    EXPECT_EQ(again.description, scenario.description);
    EXPECT_EQ(again.vehicle.imu.misalignment_deg.pitch, scenario.vehicle.imu.misalignment_deg.pitch);
  }
}

TEST(Scenario, AcceptsRangesOfTheReference) {
  EXPECT_THAT(ErrorOf(With("camera: {noise_sigma: 24.5}\n")),
              StartsWith("f.yaml:4: camera.noise_sigma: must be from 0 to 24, is 24.5"));
  EXPECT_THAT(ErrorOf(With("camera: {vibration_rad_s2_m: 0.06}\n")),
              StartsWith("f.yaml:4: camera.vibration_rad_s2_m: must be from 0 to 0.05, is 0.06"));
  EXPECT_THAT(ErrorOf(With("camera: {exposure_ms: 17}\n")),
              AllOf(StartsWith("f.yaml:4: camera: "), HasSubstr("the time between two frames")));
  EXPECT_EQ(Parse(With("camera: {noise_sigma: 24, vibration_rad_s2_m: 0.05, exposure_ms: 16}\n")).camera.noise_sigma,
            24.0);
}

TEST(Scenario, ReportsNewNameOfRenamedKey) {
  const std::string renamed = "estimator.contour_points: was renamed to estimator.paper.contour_points";
  EXPECT_THAT(ErrorOf(With("estimator: {contour_points: integer}\n")), HasSubstr(renamed));
  EXPECT_THAT(ErrorOf(With(""), {"estimator.contour_points=integer"}), HasSubstr(renamed));
  EXPECT_EQ(Parse(With("estimator: {paper: {contour_points: integer}}\n")).estimator.paper.contour_points,
            estimator::pad::ContourPoints::kInteger);
}

TEST(Scenario, RejectsUnknownControllerAndListsKnownOnes) {
  EXPECT_EQ(Parse(With("controller: {name: paper}\n")).controller.name, "paper");
  EXPECT_THAT(ErrorOf(With("controller: {name: papyrus}\n")),
              HasSubstr("controller.name: unknown controller 'papyrus', known: paper"));
}

/// Number of significant digits without trailing zeros, for example 2 for 0.00120.
std::size_t SignificantDigits(const std::string& number) {
  std::string digits;
  for (const char c : number.substr(0, number.find('e'))) {
    if (c >= '0' && c <= '9' && !(digits.empty() && c == '0')) digits += c;
  }
  return digits.find_last_not_of('0') + 1;
}

TEST(ScenarioReference, HasRoundDefaults) {
  for (const config::KeyRow& key : ScenarioReference()) {
    std::stringstream numbers(key.default_value);
    for (std::string number; std::getline(numbers, number, ',');) {
      EXPECT_LE(SignificantDigits(number), 4u) << key.path << ": " << key.default_value;
    }
  }
}

TEST(ScenarioReference, ListsKeysOfAllKinds) {
  const std::vector<config::KeyRow> reference = ScenarioReference();
  const auto has = [](const char* path, const char* unit, const char* value) {
    return Contains(AllOf(Field(&config::KeyRow::path, path), Field(&config::KeyRow::unit, unit),
                          Field(&config::KeyRow::default_value, value)));
  };
  EXPECT_THAT(reference, has("camera.exposure_ms", "ms", "4"));
  EXPECT_THAT(reference, has("camera.model.width_px", "px", "640"));
  EXPECT_THAT(reference, has("events.N.force_n", "N", "[0, 0, 0]"));
  EXPECT_THAT(reference, has("events.N.velocity_m_s", "m/s", "required"));
  EXPECT_THAT(reference, has("script.N.duration_s", "s", "required"));
  EXPECT_THAT(reference, has("start.position_m", "m", "[0, 0, 1]"));
  EXPECT_THAT(reference, has("start.x_m", "m", "0"));
  EXPECT_THAT(reference, has("estimator.paper.contour_points", "-", "subpixel"));
  EXPECT_THAT(reference, has("scene.pad", "-", "true"));
  EXPECT_THAT(reference, has("pad.marks.N.diameter_m", "m", "required"));
  EXPECT_THAT(reference, has("pad.marks.N.angle_deg", "deg", "0"));
  for (const config::KeyRow& key : reference) EXPECT_THAT(key.doc, EndsWith(".")) << key.path;
}

}  // namespace
}  // namespace touchdown::runner
