#include "sim/render/chase_view.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "models/angles.h"
#include "sim/dynamics/mujoco_model.h"
#include "sim/render/gl_scene.h"
#include "sim/render/texture_filter.h"
#include "sim/scene/geom_groups.h"
#include "sim/scene/scene.h"
#include "sim/scene/vehicle_shadow.h"

namespace touchdown::sim {
namespace {

/// View of the chase camera, 53 degrees wide and high.
constexpr PinholeView kView{.width_px = 480, .height_px = 480, .focal_px = 480.0, .cx_px = 239.5, .cy_px = 239.5};

/// Copies a model and gives its cylinders end caps, which the onboard camera's view does without.
MujocoModel CopyWithEndCaps(const mjModel& original) {
  MujocoModel model(mj_copyModel(nullptr, &original));
  if (!model) throw std::runtime_error("MuJoCo cannot copy the model");
  model->vis.quality.numstacks = std::max(2, model->vis.quality.numstacks);
  return model;
}

/// Distance from the vehicle's origin to its rotor tips, m.
double Reach(const models::Vehicle& vehicle) { return vehicle.arm_m + 0.5 * vehicle.rotor.propeller_diameter_m; }

}  // namespace

struct ChaseView::Impl {
  explicit Impl(const mjModel& original)
      : model(CopyWithEndCaps(original)),
        data(MakeData(*model)),
        scene(*model, kView, GlScene::Pixels::kBgr, MakeOsMesaContext()),
        filter(*model, scene.resources()),
        shadow(*model),
        pad_cover(mj_name2id(model.get(), mjOBJ_GEOM, kPadCoverName)) {
    mjv_defaultOption(&options);
    options.geomgroup[kInvisible] = 0;
  }

  /// Hides the walls that the camera at p_WC sees from outside the room.
  void HideWallsSeenFromOutside(const Eigen::Vector3d& p_WC) {
    for (int geom = 0; geom < model->ngeom; ++geom) {
      if (model->geom_group[geom] != kSurroundings) continue;
      const Eigen::Map<const Eigen::Vector3d> p_WG(data->geom_xpos + 3 * geom);
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R_WG(data->geom_xmat + 9 * geom);
      model->geom_rgba[4 * geom + 3] = R_WG.col(2).dot(p_WC - p_WG) > 0.0 ? 1.0F : 0.0F;
    }
  }

  MujocoModel model;
  MujocoData data;
  GlScene scene;
  TextureFilter filter;  ///< Never adapted to a view: chooses the mip level per pixel.
  VehicleShadow shadow;
  int pad_cover;
  mjvOption options;
};

ChaseView::ChaseView(const mjModel_& model, const models::Vehicle& vehicle)
    : vehicle_(vehicle), view_(kView), image_(kView.height_px, kView.width_px), impl_(std::make_unique<Impl>(model)) {}

ChaseView::~ChaseView() = default;

void ChaseView::Follow(const Eigen::Vector3d& p_WB) {
  constexpr double kDeadBand_m = 0.15, kHeading = 0.6, kDown = 0.5, kMargin = 1.03;
  if (!followed_) followed_ = p_WB;
  const Eigen::Vector3d ahead = p_WB - *followed_;
  if (ahead.norm() > kDeadBand_m) *followed_ = p_WB - kDeadBand_m * ahead.normalized();

  const double radius_m = 0.5 * followed_->norm() + Reach(vehicle_) + kDeadBand_m;
  const double half_angle = std::atan(0.5 * kView.height_px / kView.focal_px);
  const double distance_m = kMargin * radius_m / std::sin(half_angle);
  const Eigen::Vector3d forward(std::cos(kHeading) * std::cos(kDown), std::sin(kHeading) * std::cos(kDown),
                                -std::sin(kDown));
  const Eigen::Vector3d right(std::sin(kHeading), -std::cos(kHeading), 0.0);
  X_WC_.linear() << right, forward.cross(right), forward;
  X_WC_.translation() = 0.5 * *followed_ - distance_m * forward;
}

void ChaseView::AddDiscsBelow(const Eigen::Isometry3d& X_WB) {
  constexpr double kHeight_m = 0.002, kHalfThickness_m = 0.0002;
  const Eigen::Vector4f kShade(0.0F, 0.0F, 0.0F, 0.25F);
  const double radius_m = 0.5 * vehicle_.rotor.propeller_diameter_m;
  for (int rotor = 0; rotor < models::kRotorCount; ++rotor) {
    Eigen::Isometry3d X_WG = Eigen::Isometry3d::Identity();
    X_WG.translation() = X_WB * vehicle_.RotorPosition(rotor);
    X_WG.translation().z() = kHeight_m;
    impl_->scene.Add(mjGEOM_CYLINDER, {radius_m, kHalfThickness_m, 0.0}, X_WG, kShade);
  }
}

const cv::Mat3b& ChaseView::Render(const Eigen::Isometry3d& X_WB, bool pad_is_covered) {
  Impl& impl = *impl_;
  impl.scene.MakeCurrent();
  if (impl.pad_cover >= 0) impl.model->geom_rgba[4 * impl.pad_cover + 3] = pad_is_covered ? 1.0F : 0.0F;
  SetFreePose(X_WB, *impl.data);
  // Computes kinematics only, which raise no MuJoCo warnings.
  mj_kinematics(impl.model.get(), impl.data.get());
  mj_comPos(impl.model.get(), impl.data.get());
  mj_camlight(impl.model.get(), impl.data.get());
  Follow(X_WB.translation());
  impl.HideWallsSeenFromOutside(X_WC_.translation());
  impl.scene.List(*impl.data, impl.options);
  const GroundShade* const shadow = impl.shadow.Cast(*impl.data);
  if (shadow == nullptr) AddDiscsBelow(X_WB);
  impl.scene.Draw(X_WC_, shadow, image_.data);
  return image_;
}

}  // namespace touchdown::sim
