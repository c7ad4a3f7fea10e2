#include "scenarios/experiments/conditions.h"

#include <array>
#include <functional>

#include "scenarios/experiments/flight_group.h"
#include "scenarios/experiments/flight_summary.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

/// A change of one condition of the nominal flight.
struct Condition {
  std::string id;
  std::string name;
  std::function<void(runner::Scenario&)> change;
};

std::vector<Condition> Conditions() {
  std::vector<Condition> conditions{
      {"as_it_is", "as it is: noise 3 of 255, exposure 4 ms, vibration, clutter", [](runner::Scenario&) {}},
      {"calibrated_perfectly", "camera and mountings known exactly", [](runner::Scenario& s) { s.calibration = {}; }},
      {"steady", "rotors balanced: no vibration", [](runner::Scenario& s) { s.world.vibration.imbalance_kg_m = 0.0; }},
      {"uncluttered", "nothing on the floor but the pad",
       [](runner::Scenario& s) {
         s.scene.posters = s.scene.lone_circles = s.scene.lone_letters = s.scene.objects = 0;
       }},
      {"undistorted", "a lens without distortion", [](runner::Scenario& s) {
         s.camera.model.k1 = s.camera.model.k2 = 0.0;
         s.calibration.camera_model.reset();
       }}};
  for (const double sigma : {0.0, 6.0, 12.0}) {
    conditions.push_back({fmt::format("noise_{:.0f}", sigma), fmt::format("noise {:.0f} of 255", sigma),
                          [sigma](runner::Scenario& s) { s.camera.noise_sigma = sigma; }});
  }
  for (const double exposure_ms : {0.0, 8.0, 16.0}) {
    conditions.push_back({fmt::format("exposure_{:.0f}", exposure_ms), fmt::format("exposure {:.0f} ms", exposure_ms),
                          [exposure_ms](runner::Scenario& s) { s.camera.exposure_ms = exposure_ms; }});
  }
  return conditions;
}

std::string ConditionId(const Condition& condition, int seed) {
  return fmt::format("condition_{}_{}", condition.id, seed);
}

/// A hover at 1 m that starts in the air.
runner::Scenario HoverIn(const Condition& condition, const PaperPlan& plan, const PaperVehicle& vehicle, int seed) {
  runner::Scenario scenario = ShippedFlight("takeoff_hover_land", static_cast<std::uint64_t>(seed));
  scenario.start = {.airborne = true, .position_m = {0.05, -0.05, 1.0}};
  scenario.script = {
      {.kind = controller::ManeuverKind::kHover, .position_m = {0.0, 0.0, 1.0}, .duration_s = plan.condition_hover_s}};
  scenario.expect = runner::Outcome::kHovered;
  vehicle.ApplyTo(scenario);
  condition.change(scenario);
  return scenario;
}

// Maximum roll and pitch of the hand-held motion, instead of the value in hand_held.yaml.
constexpr std::array<double, 3> kHandTilts_deg = {10.0, 20.0, 30.0};

std::string ConditionId(double tilt_deg, int seed) {
  return fmt::format("condition_hand_{:.0f}_deg_{}", tilt_deg, seed);
}

/// The hand-held motion with a given maximum roll and pitch.
runner::Scenario HandWith(double tilt_deg, const PaperPlan& plan, const PaperVehicle& vehicle, int seed) {
  runner::Scenario scenario = ShippedFlight(
      "hand_held", static_cast<std::uint64_t>(seed),
      {fmt::format("hand.max_tilt_deg={}", tilt_deg), fmt::format("hand.duration_s={}", plan.condition_hand_s)});
  vehicle.ApplyTo(scenario);
  return scenario;
}

/// The flights of all seeds with `which`, a condition or a maximum tilt of the hand-held motion.
FlightGroup Flights(const Measured& measured, const PaperPlan& plan, const auto& which) {
  std::vector<std::string> ids;
  for (int seed = 1; seed <= plan.condition_seeds; ++seed) ids.push_back(ConditionId(which, seed));
  return {measured, ids};
}

report::ReportTable HoverTable(const PaperPlan& plan, const Measured& measured) {
  report::ReportTable table{
      .name = "conditions", .caption = "Mean RMSE over the rooms.", .head = ErrorHead("condition")};
  for (const char* head : {"XY, mm, whole pixels", "roll, deg, whole pixels", "pitch, deg, whole pixels"}) {
    table.head.push_back(head);
  }
  for (const Condition& condition : Conditions()) {
    const FlightGroup flights = Flights(measured, plan, condition);
    table.rows.push_back(flights.ErrorRow(condition.name, "truth"));
    for (const char* key : {"xy_mm", "roll_deg", "pitch_deg"}) {
      table.rows.back().push_back(util::FixedOrNone(flights.MeanError("integer", key), 2));
    }
  }
  return table;
}

report::ReportTable HandTable(const PaperPlan& plan, const Measured& measured) {
  report::ReportTable table{
      .name = "conditions_hand",
      .caption =
          "Hand-held motion with different maximum roll and pitch. The ellipse of the H is not rectified, and its yaw "
          "error rotates the position about the pad.",
      .head = ErrorHead("largest roll and pitch, deg")};
  for (const double tilt_deg : kHandTilts_deg) {
    table.rows.push_back(Flights(measured, plan, tilt_deg).ErrorRow(util::Fixed(tilt_deg, 0), "truth"));
  }
  return table;
}

PaperSection ReportConditions(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "conditions", .title = "Contributions to the error"}};
  section.paragraphs.push_back(
      fmt::format("A hover of {:.0f} s at 1 m in {} rooms, with one condition changed at a time. RMSE relative to the "
                  "truth with sub-pixel contour points and, on the same frames, with integer contour points. The paper "
                  "reports 38.8 mm, 1.3° and 1.4° when hovering.",
                  plan.condition_hover_s, plan.condition_seeds));
  section.tables = {HoverTable(plan, measured), HandTable(plan, measured)};
  return section;
}

}  // namespace

Experiment ConditionsExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  Experiment experiment;
  for (const Condition& condition : Conditions()) {
    for (int seed = 1; seed <= plan.condition_seeds; ++seed) {
      experiment.measurements.push_back(
          {.id = ConditionId(condition, seed),
           .expected_s = 3.0 + 1.5 * plan.condition_hover_s,
           .measure = [scenario = HoverIn(condition, plan, vehicle, seed)](const util::StopRequested& stop_requested) {
             return FlyAndSummarize(scenario, {.integer_contours = true}, stop_requested);
           }});
    }
  }
  for (const double tilt_deg : kHandTilts_deg) {
    for (int seed = 1; seed <= plan.condition_seeds; ++seed) {
      experiment.measurements.push_back(
          {.id = ConditionId(tilt_deg, seed),
           .expected_s = 3.0 + 1.3 * plan.condition_hand_s,
           .measure = [scenario = HandWith(tilt_deg, plan, vehicle, seed)](const util::StopRequested& stop_requested) {
             return FlyAndSummarize(scenario, {}, stop_requested);
           }});
    }
  }
  experiment.report = [plan](const Measured& measured) { return ReportConditions(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
