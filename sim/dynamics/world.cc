#include "sim/dynamics/world.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "models/angles.h"
#include "models/error.h"
#include "sim/dynamics/aerodynamics.h"
#include "sim/dynamics/vehicle_mjcf.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

MujocoModel LoadWorld(const WorldConfig& config, const models::Vehicle& vehicle, const Scene& scene,
                      const models::TimeBase& time) {
  config.Validate();
  vehicle.Validate();
  MujocoModel model = LoadModel(SceneMjcf(scene, VehicleMjcf(vehicle), time.period_s()));
  Eigen::Map<Vector3d>(model->opt.gravity) = config.ground_tilt.Gravity();
  if (config.paint_textures) PaintTextures(scene, *model);
  return model;
}

Eigen::Isometry3d UprightPose(const Vector3d& p_WB, double yaw) {
  Eigen::Isometry3d X_WB(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  X_WB.translation() = p_WB;
  return X_WB;
}

}  // namespace

void Describe(models::ConfigVisitor& v, WorldConfig& c) {
  v.Vector3({"wind_m_s", "Mean wind in W. Events of the scenario can change it."}, c.wind_m_s, models::kMeterPerSecond,
            models::Between(-50.0, 50.0));
  v.Numbers({"ground_tilt_deg",
             "Roll and pitch of the ground, and of W with it, relative to level. The slope is at most 15 "
             "degrees."},
            {&c.ground_tilt.roll_deg, &c.ground_tilt.pitch_deg}, models::kDegree, models::Between(-15.0, 15.0));
  Describe(v, c.vibration);
  v.Check("ground_tilt_deg", [&c] { c.ground_tilt.Validate(); });
}

void WorldConfig::Validate() const { models::ValidateConfig(*this); }

World::World(const WorldConfig& config, const models::Vehicle& vehicle, const Scene& scene,
             const models::TimeBase& time, std::uint64_t seed)
    : config_(config),
      vehicle_(vehicle),
      time_(time),
      rotors_(vehicle, config.vibration, time, seed),
      model_(LoadWorld(config, vehicle, scene, time)),
      data_(MakeData(*model_)),
      vehicle_body_(mj_name2id(model_.get(), mjOBJ_BODY, kVehicleBodyName)),
      pad_cover_(mj_name2id(model_.get(), mjOBJ_GEOM, kPadCoverName)),
      is_foot_(static_cast<std::size_t>(model_->ngeom), false) {
  for (int foot = 0; foot < models::kRotorCount; ++foot) {
    is_foot_[static_cast<std::size_t>(mj_name2id(model_.get(), mjOBJ_GEOM, FootName(foot).c_str()))] = true;
  }
  resting_height_m_ = FindRestingHeight();
  contact_ceiling_m_ = FindContactCeiling();
  Reset(RestingPose(0.0, 0.0, 0.0), false);
}

World::~World() = default;

void World::Reset(const Eigen::Isometry3d& X_WB, bool rotors_at_hover) {
  if (!X_WB.matrix().allFinite()) throw SimulationError("the vehicle's initial pose is not finite");
  mj_resetData(model_.get(), data_.get());
  SetFreePose(X_WB, *data_);
  mj_forward(model_.get(), data_.get());
  PopMujocoWarning();
  rotors_.Reset(rotors_at_hover ? vehicle_.rotor.SpeedFor(vehicle_.HoverThrustPerRotor()) : 0.0);
  SetWind(config_.wind_m_s);
  SetGust(Vector3d::Zero());
  SetPush(Vector3d::Zero(), Vector3d::Zero());
  CoverPad(false);
  state_ = TrueState{};
  ReadState();
}

Eigen::Isometry3d World::RestingPose(double x_m, double y_m, double yaw) const {
  return UprightPose({x_m, y_m, resting_height_m_}, yaw);
}

void World::SetPush(const Vector3d& force_n, const Vector3d& torque_n_m) {
  push_force_n_ = force_n;
  push_torque_n_m_ = torque_n_m;
}

void World::CoverPad(bool covered) {
  if (pad_cover_ >= 0) model_->geom_rgba[4 * pad_cover_ + 3] = covered ? 1.0F : 0.0F;
}

std::optional<double> World::DistanceAlong(const Vector3d& p_W, const Vector3d& direction_W) const {
  constexpr const mjtByte* kAllGroups = nullptr;
  constexpr mjtByte kIncludeStatic = 1;
  int geom = -1;
  const double distance_m = mj_ray(model_.get(), data_.get(), p_W.data(), direction_W.data(), kAllGroups,
                                   kIncludeStatic, vehicle_body_, &geom);
  if (distance_m < 0.0) return std::nullopt;
  return distance_m;
}

void World::Step(const models::RotorCommand& command) {
  for (const double speed : command.speed_rad_s) {
    if (!std::isfinite(speed)) throw SimulationError("the rotor command is not finite");
  }
  ApplyForces(AppliedWrench(command));
  StepMujoco();
  Advance();
}

void World::Carry(const BodyMotion& motion) {
  if (!motion.X_WB.matrix().allFinite()) throw SimulationError("the hand's pose is not finite");
  SetFreePose(motion.X_WB, *data_);
  Eigen::Map<Vector3d>(data_->qvel) = motion.v_WB;
  Eigen::Map<Vector3d>(data_->qvel + 3) = motion.w_WB_B;
  mj_forward(model_.get(), data_.get());
  PopMujocoWarning();
  Advance();
}

/// Reads the state after a step of MuJoCo.
void World::Advance() {
  const TrueState before = state_;
  ++state_.tick;
  ReadState();
  state_.a_WB = (state_.v_WB - before.v_WB) / time_.period_s();
  state_.alpha_WB_B = (state_.w_WB_B - before.w_WB_B) / time_.period_s();
}

/// Finds, by bisection, the height at which the contact forces carry the weight.
double World::FindRestingHeight() {
  double upper = vehicle_.gear.height_m;
  double lower = upper - vehicle_.gear.foot_radius_m;
  constexpr int kBisections = 40;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (upper + lower);
    mj_resetData(model_.get(), data_.get());
    SetFreePose(UprightPose({0.0, 0.0, middle}, 0.0), *data_);
    mj_forward(model_.get(), data_.get());
    (data_->qacc[2] > 0.0 ? lower : upper) = middle;
  }
  return 0.5 * (upper + lower);
}

double World::FindContactCeiling() const {
  double highest_object = -mjMAXVAL, vehicle_radius = 0.0;
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    if (model_->geom_contype[geom] == 0) continue;
    const bool is_plane = model_->geom_type[geom] == mjGEOM_PLANE;
    const double radius = is_plane ? 0.0 : model_->geom_rbound[geom];
    if (model_->geom_bodyid[geom] == vehicle_body_) {
      vehicle_radius =
          std::max(vehicle_radius, Eigen::Map<const Vector3d>(model_->geom_pos + 3 * geom).norm() + radius);
    } else {
      highest_object = std::max(highest_object, data_->geom_xpos[3 * geom + 2] + radius);
    }
  }
  constexpr double kMaxFallPerTick_m = 0.1;
  return highest_object + vehicle_radius + kMaxFallPerTick_m;
}

/// Wrench in B over the next tick, without push, gravity and contact.
Wrench World::AppliedWrench(const models::RotorCommand& command) {
  Wrench wrench = rotors_.Step(command);
  wrench.force_n += DragForce(vehicle_, state_.X_WB.linear().transpose() * (state_.v_WB - wind_m_s_ - gust_m_s_));
  return wrench;
}

void World::ApplyForces(const Wrench& wrench) {
  const Eigen::Matrix3d R_WB = state_.X_WB.linear() * models::RotationExp(0.5 * time_.period_s() * state_.w_WB_B);
  // MuJoCo expects the force on a free joint in W and the torque in B.
  Eigen::Map<Vector3d> force_W(data_->qfrc_applied), torque_B(data_->qfrc_applied + 3);
  force_W = R_WB * wrench.force_n + push_force_n_;
  torque_B = wrench.torque_n_m + R_WB.transpose() * push_torque_n_m_;
  if (!force_W.allFinite() || !torque_B.allFinite()) throw SimulationError("a force on the vehicle is not finite");
}

void World::StepMujoco() {
  // Contact detection takes three quarters of a step near the floor. It is not needed far above it.
  const bool out_of_reach = state_.X_WB.translation().z() > contact_ceiling_m_;
  model_->opt.disableflags = out_of_reach ? mjDSBL_CONTACT : 0;
  const double time_before_s = data_->time;
  mj_step(model_.get(), data_.get());
  const std::optional<std::string> warning = PopMujocoWarning();
  if (warning) throw SimulationError("MuJoCo: " + *warning);
  if (std::any_of(std::begin(data_->warning), std::end(data_->warning),
                  [](const mjWarningStat& kind) { return kind.number > 0; })) {
    throw SimulationError("MuJoCo raised a warning");
  }
  constexpr double kRoundOff_s = 1e-9;
  if (!(std::abs(data_->time - time_before_s - time_.period_s()) < kRoundOff_s)) {
    throw SimulationError("the simulated time did not advance by a tick");
  }
}

void World::ReadState() {
  const double* q = data_->qpos;
  const double* v = data_->qvel;
  if (!Eigen::Map<const Eigen::Matrix<double, 7, 1>>(q).allFinite() ||
      !Eigen::Map<const Eigen::Matrix<double, 6, 1>>(v).allFinite()) {
    throw SimulationError("the vehicle's state is not finite");
  }
  state_.X_WB.linear() = Eigen::Quaterniond(q[3], q[4], q[5], q[6]).normalized().toRotationMatrix();
  state_.X_WB.translation() = Vector3d(q[0], q[1], q[2]);
  state_.v_WB = Vector3d(v[0], v[1], v[2]);
  state_.w_WB_B = Vector3d(v[3], v[4], v[5]);
  state_.rotor_speed_rad_s = rotors_.speeds_rad_s();
  state_.vibration_m_s2_B = rotors_.Imbalance().force_n / vehicle_.mass_kg;
  ReadContacts();
}

void World::ReadContacts() {
  state_.gear_in_contact = state_.body_in_contact = false;
  for (int i = 0; i < data_->ncon; ++i) {
    for (const int geom : {data_->contact[i].geom1, data_->contact[i].geom2}) {
      if (model_->geom_bodyid[geom] != vehicle_body_) continue;
      (is_foot_[static_cast<std::size_t>(geom)] ? state_.gear_in_contact : state_.body_in_contact) = true;
    }
  }
}

}  // namespace touchdown::sim
