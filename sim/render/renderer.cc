#include "sim/render/renderer.h"

#include <mujoco/mujoco.h>

#include <optional>
#include <utility>

#include "sim/render/floor_footprint.h"
#include "sim/render/gl_scene.h"
#include "sim/render/texture_filter.h"
#include "sim/scene/geom_groups.h"
#include "sim/scene/textures.h"
#include "sim/scene/vehicle_shadow.h"

namespace touchdown::sim {
namespace {

/// Whether the view shows no part of the floor outside its center.
bool IsWithinFloorCenter(const FloorFootprint& footprint) {
  constexpr double kMargin_m = 0.02;
  return footprint.reach_m < 0.5 * kFloorCenterSize_m - kMargin_m;
}

}  // namespace

struct Renderer::Impl {
  Impl(const mjModel& model, const PinholeView& view, std::unique_ptr<GlContext> gl)
      : scene(model, view, GlScene::Pixels::kRed, std::move(gl)), filter(model, scene.resources()), shadow(model) {
    mjv_defaultOption(&options);
    options.geomgroup[kVehicle] = options.geomgroup[kInvisible] = 0;
  }

  GlScene scene;
  TextureFilter filter;
  VehicleShadow shadow;
  mjvOption options;
};

Renderer::Renderer(const mjModel_& model, const PinholeView& view, std::unique_ptr<GlContext> context)
    : view_(view),
      image_(view.width_px, view.height_px),
      impl_(std::make_unique<Impl>(model, view, std::move(context))) {}

Renderer::~Renderer() = default;

const models::Image& Renderer::Render(mjData_& data, const Eigen::Isometry3d& X_WC) {
  Impl& impl = *impl_;
  impl.scene.MakeCurrent();
  const std::optional<FloorFootprint> footprint = FootprintOf(view_, X_WC);
  impl.options.geomgroup[kSurroundings] = footprint && IsWithinFloorCenter(*footprint) ? 0 : 1;
  impl.filter.AdaptTo(footprint, view_.focal_px);
  impl.scene.List(data, impl.options);
  impl.scene.Draw(X_WC, impl.shadow.Cast(data), image_.Row(0));
  return image_;
}

}  // namespace touchdown::sim
