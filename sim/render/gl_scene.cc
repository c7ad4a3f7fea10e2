#include "sim/render/gl_scene.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace touchdown::sim {
namespace {

constexpr int kMaxGeoms = 400;
/// Near and far clipping planes: 24 bits of depth from 2 cm to 40 m resolve sheets 0.2 mm apart up to 8 m away.
constexpr double kNearPlane_m = 0.02;
constexpr double kFarPlane_m = 40.0;

/// OpenGL camera for a view from X_WC. It looks along its -Z and has Y up. An asymmetric frustum places the principal
/// point with subpixel accuracy.
mjvGLCamera CameraFor(const PinholeView& view, const Eigen::Isometry3d& X_WC) {
  mjvGLCamera camera{};
  for (int i = 0; i < 3; ++i) {
    camera.pos[i] = static_cast<float>(X_WC.translation()[i]);
    camera.forward[i] = static_cast<float>(X_WC.linear()(i, 2));
    camera.up[i] = static_cast<float>(-X_WC.linear()(i, 1));
  }
  const double meters_per_px = kNearPlane_m / view.focal_px;
  camera.frustum_center = static_cast<float>((0.5 * (view.width_px - 1) - view.cx_px) * meters_per_px);
  camera.frustum_top = static_cast<float>((view.cy_px + 0.5) * meters_per_px);
  camera.frustum_bottom = static_cast<float>((view.cy_px + 0.5 - view.height_px) * meters_per_px);
  camera.frustum_near = static_cast<float>(kNearPlane_m);
  camera.frustum_far = static_cast<float>(kFarPlane_m);
  return camera;
}

void AttachBuffer(GLenum attachment, GLenum format, const PinholeView& view) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, view.width_px, view.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

/// Replaces the attachments of the bound off-screen buffer: only the color channels that are read, and a depth buffer
/// without an interleaved stencil, which would slow down clearing.
void KeepOnlyColorAndDepth(const PinholeView& view, GLenum color_format) {
  constexpr GLuint kNone = 0;
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, kNone);
  AttachBuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, view);
  AttachBuffer(GL_COLOR_ATTACHMENT0, color_format, view);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL cannot render into a buffer with color and depth only");
  }
}

}  // namespace

GlScene::GeomList::GeomList(const mjModel& model) {
  mjv_defaultScene(this);
  mjv_makeScene(&model, this, kMaxGeoms);
  for (const int flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_FOG, mjRND_HAZE}) flags[flag] = 0;
}

GlScene::Resources::Resources(const mjModel& model, const PinholeView& view) {
  mjModel sized = model;
  sized.vis.global.offwidth = view.width_px;
  sized.vis.global.offheight = view.height_px;
  mjr_defaultContext(this);
  mjr_makeContext(&sized, this, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, this);
}

GlScene::GlScene(const mjModel& model, const PinholeView& view, Pixels pixels, std::unique_ptr<GlContext> context)
    : model_(model),
      view_(view),
      pixels_(pixels),
      gl_((context->MakeCurrent(), std::move(context))),
      geoms_(model),
      resources_(model, view),
      bottom_up_(static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px) * bytes_per_px()) {
  if (resources_.currentBuffer != mjFB_OFFSCREEN || resources_.offWidth < view.width_px) {
    throw std::runtime_error("MuJoCo's renderer cannot make an off-screen buffer for the camera's view");
  }
  KeepOnlyColorAndDepth(view, pixels == Pixels::kRed ? GL_R8 : GL_RGBA8);
}

void GlScene::List(mjData& data, const mjvOption& options) {
  mjvCamera unused;
  mjv_defaultCamera(&unused);
  mjv_updateScene(&model_, &data, &options, nullptr, &unused, mjCAT_ALL, &geoms_);
}

void GlScene::Add(mjtGeom type, const Eigen::Vector3d& size_m, const Eigen::Isometry3d& X_WG,
                  const Eigen::Vector4f& rgba) {
  if (geoms_.ngeom >= geoms_.maxgeom) return;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R_WG = X_WG.linear();
  mjv_initGeom(geoms_.geoms + geoms_.ngeom, type, size_m.data(), X_WG.translation().data(), R_WG.data(), rgba.data());
  ++geoms_.ngeom;
}

void GlScene::Draw(const Eigen::Isometry3d& X_WC, const GroundShade* shade, std::uint8_t* pixels) {
  geoms_.camera[0] = geoms_.camera[1] = CameraFor(view_, X_WC);
  mjr_render({0, 0, view_.width_px, view_.height_px}, &geoms_, &resources_);
  if (shade != nullptr) shade_painter_.Paint(*shade);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, view_.width_px, view_.height_px, pixels_ == Pixels::kRed ? GL_RED : GL_BGR, GL_UNSIGNED_BYTE,
               bottom_up_.data());
  const std::size_t row_bytes = static_cast<std::size_t>(view_.width_px) * bytes_per_px();
  for (int v = view_.height_px - 1; v >= 0; --v, pixels += row_bytes) {
    std::copy_n(bottom_up_.data() + static_cast<std::size_t>(v) * row_bytes, row_bytes, pixels);
  }
}

}  // namespace touchdown::sim
