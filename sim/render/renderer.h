#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "models/signals.h"
#include "sim/render/gl_context.h"
#include "sim/render/pinhole_view.h"

struct mjModel_;
struct mjData_;

namespace touchdown::sim {

/// Renders the image of an ideal pinhole camera, without lens distortion, exposure time and noise, with MuJoCo's
/// renderer in a GL context of its own.
///
/// The image is the red channel. The vehicle is hidden (see GeomGroup), but its shadow is visible under a sun. A
/// process can have several renderers, on one thread or on several.
class Renderer {
 public:
  /// Copies the model's textures into the GL context, which only this renderer uses; `model` must outlive the renderer.
  /// Throws std::runtime_error when there is no buffer for a view of that size.
  Renderer(const mjModel_& model, const PinholeView& view, std::unique_ptr<GlContext> context = MakeOsMesaContext());
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Renders the view from X_WC (frame C: X right, Y down, Z forward), row 0 at the top. `data` must have its
  /// kinematics computed (mj_forward, mj_step). The image is valid until the next call.
  const models::Image& Render(mjData_& data, const Eigen::Isometry3d& X_WC);

 private:
  struct Impl;

  PinholeView view_;
  models::Image image_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sim
