#include "sim/renderer.h"

#include <GL/gl.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sim/gl_context.h"

namespace touchdown::sim {
namespace {

constexpr int kVehicleGroup = 2;
constexpr int kInvisibleGroup = 3;
constexpr int kMaxGeoms = 400;
/// 24 bits of depth from 2 cm to 40 m tell sheets 0.2 mm apart up to 8 m away.
constexpr double kNear_m = 0.02;
constexpr double kFar_m = 40.0;

/// OpenGL's camera looks along its -Z and has Y up. The frustum is cut so that the principal point falls where the view
/// wants it, to the fraction of a pixel.
mjvGLCamera CameraFor(const PinholeView& view, const Eigen::Isometry3d& X_WC) {
  mjvGLCamera camera{};
  for (int i = 0; i < 3; ++i) {
    camera.pos[i] = static_cast<float>(X_WC.translation()[i]);
    camera.forward[i] = static_cast<float>(X_WC.linear()(i, 2));
    camera.up[i] = static_cast<float>(-X_WC.linear()(i, 1));
  }
  const double metres_per_px = kNear_m / view.focal_px;
  camera.frustum_center = static_cast<float>((0.5 * (view.width_px - 1) - view.cx_px) * metres_per_px);
  camera.frustum_top = static_cast<float>((view.cy_px + 0.5) * metres_per_px);
  camera.frustum_bottom = static_cast<float>((view.cy_px + 0.5 - view.height_px) * metres_per_px);
  camera.frustum_near = static_cast<float>(kNear_m);
  camera.frustum_far = static_cast<float>(kFar_m);
  return camera;
}

}  // namespace

struct Renderer::Impl {
  Impl(const mjModel& model_in, const PinholeView& view) : model(model_in), gl(MakeOsMesaContext()) {
    mjv_defaultOption(&options);
    options.geomgroup[kVehicleGroup] = 0;
    options.geomgroup[kInvisibleGroup] = 0;
    mjv_defaultCamera(&free_camera);
    mjv_defaultScene(&scene);
    mjv_makeScene(&model, &scene, kMaxGeoms);
    for (const int flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_FOG, mjRND_HAZE}) scene.flags[flag] = 0;

    mjModel sized = model;
    sized.vis.global.offwidth = view.width_px;
    sized.vis.global.offheight = view.height_px;
    mjr_defaultContext(&context);
    mjr_makeContext(&sized, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    if (context.currentBuffer != mjFB_OFFSCREEN || context.offWidth < view.width_px) {
      throw std::runtime_error("MuJoCo's renderer cannot make an off-screen buffer for the camera's view");
    }
    const std::size_t pixels = static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px);
    rgba.resize(4 * pixels);
  }

  ~Impl() {
    gl->MakeCurrent();
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }

  const mjModel& model;
  std::unique_ptr<GlContext> gl;
  mjvOption options;
  mjvCamera free_camera;
  mjvScene scene;
  mjrContext context;
  std::vector<std::uint8_t> rgba;
};

Renderer::Renderer(const mjModel_& model, const PinholeView& view)
    : view_(view), image_(view.width_px, view.height_px), impl_(std::make_unique<Impl>(model, view)) {}

Renderer::~Renderer() = default;

const models::Image& Renderer::Render(mjData_& data, const Eigen::Isometry3d& X_WC) {
  Impl& impl = *impl_;
  impl.gl->MakeCurrent();
  mjv_updateScene(&impl.model, &data, &impl.options, nullptr, &impl.free_camera, mjCAT_ALL, &impl.scene);
  impl.scene.camera[0] = impl.scene.camera[1] = CameraFor(view_, X_WC);
  const mjrRect viewport{0, 0, view_.width_px, view_.height_px};
  mjr_render(viewport, &impl.scene, &impl.context);
  glReadPixels(0, 0, view_.width_px, view_.height_px, GL_RGBA, GL_UNSIGNED_BYTE, impl.rgba.data());

  for (int v = 0; v < view_.height_px; ++v) {
    const std::uint8_t* rgba =
        impl.rgba.data() + 4 * static_cast<std::ptrdiff_t>(view_.height_px - 1 - v) * view_.width_px;
    std::uint8_t* grey = image_.Row(v);
    for (int u = 0; u < view_.width_px; ++u) grey[u] = rgba[4 * u + 1];
  }
  return image_;
}

}  // namespace touchdown::sim
