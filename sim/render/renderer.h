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

/// Image of an ideal pinhole camera, without lens errors, exposure time and noise: MuJoCo's renderer on its own GL
/// context.
///
/// The camera's spectral response is the red channel. Of the geom groups, see GeomGroup, the vehicle is not shown,
/// but under a sun its shadow is.
/// Several renderers can live in one process, on one thread each or on the same.
class Renderer {
 public:
  /// Copies the model's textures into the GL context, which is the renderer's alone; `model` must outlive it. Throws
  /// std::runtime_error when there is no buffer for a view of that size.
  Renderer(const mjModel_& model, const PinholeView& view, std::unique_ptr<GlContext> context = MakeOsMesaContext());
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Renders the view from X_WC (frame C: X right, Y down, Z forward), row 0 at the top. `data` must have its
  /// kinematics computed (mj_forward, mj_step); only the shadow of the vehicle is used. The image is valid until the
  /// next call.
  const models::Image& Render(mjData_& data, const Eigen::Isometry3d& X_WC);

 private:
  struct Impl;

  PinholeView view_;
  models::Image image_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sim
