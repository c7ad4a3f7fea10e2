#include "sim/scene/vehicle_shadow.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/scene/geom_groups.h"
#include "sim/scene/scene.h"
#include "sim/scene/shadow_mask.h"
#include "sim/scene/shadow_outline.h"
#include "sim/scene/solid.h"

namespace touchdown::sim {
namespace {

constexpr int kSide = 256;
/// Opacity of a spinning two-bladed propeller, of 255: area of the blades divided by area of the disc.
constexpr std::uint8_t kBladesOpacity = 31;
constexpr std::uint8_t kOpaque = 255;
/// Standard deviation of the penumbra per meter of distance, for a solar disc of 0.53 degrees.
constexpr double kBlurPerMeter = 0.0093 / 4.0;

}  // namespace

VehicleShadow::VehicleShadow(const mjModel& model) : model_(model), mask_(kSide, kSide) {
  const int sun = mj_name2id(&model, mjOBJ_LIGHT, kSunName);
  if (sun < 0 || model.light_diffuse[3 * sun] == 0.0F) return;
  to_sun_ = -Eigen::Map<const Eigen::Vector3d>(model.light_dir + 3 * sun);
  shade_ = model.light_ambient[3 * sun];
  cast_.light.create(kSide, kSide);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_group[geom] == kVehicle) {
      parts_.push_back({geom, model.geom_rgba[4 * geom + 3] < 1.0F ? kBladesOpacity : kOpaque});
    } else if (model.geom_group[geom] == kScenery && model.geom_type[geom] != mjGEOM_PLANE) {
      solids_.push_back(geom);
    }
  }
  std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.opacity < b.opacity; });
}

VehicleShadow::Outline VehicleShadow::OutlineOf(const mjData& data, int geom) const {
  Solid solid{.type = static_cast<mjtGeom>(model_.geom_type[geom]),
              .size_m = Eigen::Map<const Eigen::Vector3d>(model_.geom_size + 3 * geom)};
  solid.X_WG.translation() = Eigen::Map<const Eigen::Vector3d>(data.geom_xpos + 3 * geom);
  solid.X_WG.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.geom_xmat + 9 * geom);
  return ShadowOutline(solid, *to_sun_);
}

/// Fits the shaded square of the ground to all outlines, with a margin for the blur.
void VehicleShadow::FitSquare(const std::vector<Outline>& outlines, double blur_m) {
  Eigen::AlignedBox2d box;
  for (const Outline& outline : outlines) {
    for (const Eigen::Vector2d& corner : outline) box.extend(corner);
  }
  constexpr double kBorder = 1.0 + 6.0 / kSide;
  cast_.center_m = box.center();
  cast_.side_m = kBorder * (box.sizes().maxCoeff() + 6.0 * blur_m);
}

const GroundShade* VehicleShadow::Cast(const mjData& data) {
  if (!to_sun_ || parts_.empty()) return nullptr;
  std::vector<Outline> outlines;
  for (const Part& part : parts_) outlines.push_back(OutlineOf(data, part.geom));
  const double height_m = std::max(0.0, data.geom_xpos[3 * parts_.back().geom + 2]);
  const double blur_m = kBlurPerMeter * height_m / to_sun_->z();
  FitSquare(outlines, blur_m);

  const auto pixel_of = [this](const Eigen::Vector2d& p_W) {
    const Eigen::Vector2d fraction = (p_W - cast_.center_m) / cast_.side_m;
    return Eigen::Vector2d(kSide * (fraction.x() + 0.5) - 0.5, kSide * (0.5 - fraction.y()) - 0.5);
  };
  mask_.setTo(0);
  for (std::size_t i = 0; i < parts_.size(); ++i) FillOutline(outlines[i], pixel_of, parts_[i].opacity, mask_);
  const double blur_px = blur_m * kSide / cast_.side_m;
  if (blur_px > 0.3) cv::GaussianBlur(mask_, mask_, {}, blur_px);
  for (const int solid : solids_) FillOutline(OutlineOf(data, solid), pixel_of, 0, mask_);
  mask_.convertTo(cast_.light, CV_8U, shade_ - 1.0, 255.0);
  return &cast_;
}

}  // namespace touchdown::sim
