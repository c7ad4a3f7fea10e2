#include "controller/flight_controller.h"

#include <algorithm>
#include <utility>

namespace touchdown::controller {
namespace {

const models::Vehicle& Valid(const models::Vehicle& vehicle) {
  vehicle.Validate();
  return vehicle;
}

PadWatch::Settings PadSettings(const FlightControllerConfig& config, const models::TimeBase& time) {
  config.Validate();
  return {.lost_after = time.FromSeconds(config.guidance.pad_lost_s),
          .found_after = time.FromSeconds(config.guidance.pad_found_s),
          .fresh_for = time.FromSeconds(config.vision_fresh_s)};
}

bool MotorsOff(Phase phase) { return phase == Phase::kStandby || phase == Phase::kTouchdown; }

}  // namespace

std::vector<std::string> ControllerNames() { return {"paper"}; }

void RequireControllerName(const std::string& name) {
  const std::vector<std::string> names = ControllerNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
  throw InputError("unknown controller '" + name + "', known: " + known);
}

void Describe(models::ConfigVisitor& v, FlightControllerConfig& c) {
  v.Text({"name", "Controller that flies the vehicle."}, c.name);
  v.Check("name", [&c] { RequireControllerName(c.name); });
  v.Keys({"guidance",
          "Guidance (Sec. V), which generates set-points for takeoff, landing, and the search for a lost pad."},
         c.guidance);
  v.Keys({"position", "Outer loop, which converts position errors to thrust and tilt."}, c.position);
  v.Keys({"attitude", "Inner loop, which converts attitude errors to torque."}, c.attitude);
  v.Number(
      {"vision_fresh_s",
       "Largest age of the newest detection of the pad at which the position loop uses vision. When the detection is "
       "older, the loop uses its own prediction."},
      c.vision_fresh_s, models::kSecond, models::kPositiveTime);
}

void FlightControllerConfig::Validate() const { models::ValidateConfig(*this); }

FlightController::FlightController(const FlightControllerConfig& config, const models::Vehicle& vehicle,
                                   const models::TimeBase& time, int rate_hz, std::vector<Maneuver> script,
                                   bool starts_airborne)
    : config_(config),
      weight_n_(Valid(vehicle).mass_kg * models::kGravity_m_s2),
      standing_height_m_(vehicle.gear.height_m),
      pad_(PadSettings(config, time)),
      guidance_(config.guidance, time, time.ToSeconds(time.PeriodOf(rate_hz)), standing_height_m_, std::move(script),
                starts_airborne),
      position_(config.position, vehicle, time.ToSeconds(time.PeriodOf(rate_hz))),
      attitude_(config.attitude, vehicle, time.ToSeconds(time.PeriodOf(rate_hz))),
      mixer_(vehicle),
      predictor_(vehicle, time.ToSeconds(time.PeriodOf(rate_hz)), starts_airborne ? weight_n_ : 0.0) {}

ControlOutput FlightController::Update(const models::VehicleEstimate& estimate) {
  pad_.Update(estimate.tick, estimate.pad_seen);
  ControlOutput output;
  output.motion_is_predicted = MotionIsPredicted(estimate);
  if (!output.motion_is_predicted) predictor_.Set(*estimate.motion);
  output.motion = predictor_.motion();

  const Guidance::Output guidance = guidance_.Update(
      {.tick = estimate.tick, .motion = output.motion, .pad_lost = pad_.lost(), .pad_found = pad_.found()});
  output.phase = guidance.phase;
  output.set_point_m = guidance.p_m;
  output.script_done = guidance.script_done;
  if (MotorsOff(guidance.phase)) {
    ResetOnGround(estimate.attitude);
    return output;
  }

  const PositionController::Demand demand = Follow(guidance, output.motion, estimate.attitude);
  output.attitude_set_point = {.roll = demand.roll, .pitch = demand.pitch, .yaw = 0.0};
  const Eigen::Vector3d torque = attitude_.Torque(output.attitude_set_point, estimate.attitude, estimate.w_WB_B);
  const Mixer::Result mixed = mixer_.Mix({.thrust_n = demand.thrust_n, .torque_n_m = torque});
  output.rotors = mixed.rotors;
  output.thrust_n = mixed.achieved.thrust_n;
  output.torque_n_m = mixed.achieved.torque_n_m;

  Integrate(output, guidance);
  predictor_.Step(estimate.attitude, output.thrust_n, position_.trim_m_s2());
  if (guidance.phase == Phase::kBlindClimb) predictor_.StandAt(standing_height_m_);
  return output;
}

bool FlightController::MotionIsPredicted(const models::VehicleEstimate& estimate) const {
  const double vision_floor_m = standing_height_m_ + config_.guidance.vision_floor_clearance_m;
  const bool blind = guidance_.phase() == Phase::kBlindDescent || guidance_.phase() == Phase::kBlindClimb;
  const bool too_low = blind && predictor_.motion().p_WB.z() < vision_floor_m;
  return too_low || MotorsOff(guidance_.phase()) || !estimate.motion.has_value() || !pad_.found() || !pad_.fresh();
}

PositionController::Demand FlightController::Follow(const Guidance::Output& guidance,
                                                    const models::VehicleEstimate::Motion& motion,
                                                    const models::TaitBryan& attitude) {
  if (guidance.phase == Phase::kBlindClimb) {
    PositionController::Demand demand = position_.Trimmed(attitude);
    demand.thrust_n = guidance.thrust_ratio * weight_n_;
    return demand;
  }
  return position_.Update({.p_m = guidance.p_m, .v_m_s = guidance.v_m_s}, motion, attitude);
}

void FlightController::ResetOnGround(const models::TaitBryan& attitude) {
  attitude_.Reset();
  predictor_.Set({.p_WB = {0.0, 0.0, standing_height_m_}, .v_WB = Eigen::Vector3d::Zero()});
  if (guidance_.phase() == Phase::kStandby) position_.SetTrimFromStance(attitude);
}

void FlightController::Integrate(const ControlOutput& output, const Guidance::Output& guidance) {
  const bool lifted = guidance.phase != Phase::kBlindClimb || guidance.thrust_ratio > 1.0;
  if (lifted && guidance.phase != Phase::kBlindDescent) attitude_.Integrate(output.torque_n_m);
  if (!output.motion_is_predicted && guidance.phase != Phase::kBlindClimb) position_.Integrate(output.thrust_n);
}

}  // namespace touchdown::controller
