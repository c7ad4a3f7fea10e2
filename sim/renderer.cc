#include "sim/renderer.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/floor_footprint.h"
#include "sim/geom_groups.h"
#include "sim/texture_filter.h"
#include "sim/textures.h"

namespace touchdown::sim {
namespace {

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

/// Whether all that the view shows lies above or on the floor's centre.
bool LiesOnTheFloorsCentre(const FloorFootprint& footprint) {
  constexpr double kMargin_m = 0.02;
  return footprint.reach_m < 0.5 * kFloorCentreSize_m - kMargin_m;
}

void AttachBuffer(GLenum attachment, GLenum format, const PinholeView& view) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, view.width_px, view.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

/// Gives the off-screen buffer that is bound now what the camera reads and no more: the red channel, at a quarter of
/// the bandwidth, and depth without a stencil interleaved, which is slow to clear around.
void KeepOnlyRedAndDepth(const PinholeView& view) {
  constexpr GLuint kNone = 0;
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, kNone);
  AttachBuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, view);
  AttachBuffer(GL_COLOR_ATTACHMENT0, GL_R8, view);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL cannot render into a buffer of one channel and depth");
  }
}

/// MuJoCo's list of what is drawn.
class GeomList : public mjvScene {
 public:
  explicit GeomList(const mjModel& model) {
    mjv_defaultScene(this);
    mjv_makeScene(&model, this, kMaxGeoms);
    for (const int flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_FOG, mjRND_HAZE}) flags[flag] = 0;
  }
  ~GeomList() { mjv_freeScene(this); }
  GeomList(const GeomList&) = delete;
  GeomList& operator=(const GeomList&) = delete;
};

/// What MuJoCo keeps in the GL context that is current: textures, and an off-screen buffer of the view's size.
class GlResources : public mjrContext {
 public:
  GlResources(const mjModel& model, const PinholeView& view) {
    mjModel sized = model;
    sized.vis.global.offwidth = view.width_px;
    sized.vis.global.offheight = view.height_px;
    mjr_defaultContext(this);
    mjr_makeContext(&sized, this, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, this);
  }
  ~GlResources() { mjr_freeContext(this); }
  GlResources(const GlResources&) = delete;
  GlResources& operator=(const GlResources&) = delete;
};

}  // namespace

struct Renderer::Impl {
  Impl(const mjModel& model_in, const PinholeView& view, std::unique_ptr<GlContext> gl_in)
      : model(model_in),
        gl((gl_in->MakeCurrent(), std::move(gl_in))),
        geoms(model),
        resources(model, view),
        filter(model, resources) {
    if (resources.currentBuffer != mjFB_OFFSCREEN || resources.offWidth < view.width_px) {
      throw std::runtime_error("MuJoCo's renderer cannot make an off-screen buffer for the camera's view");
    }
    KeepOnlyRedAndDepth(view);
    mjv_defaultOption(&options);
    options.geomgroup[kVehicle] = options.geomgroup[kInvisible] = 0;
    mjv_defaultCamera(&free_camera);
    bottom_up.resize(static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px));
  }

  const mjModel& model;
  std::unique_ptr<GlContext> gl;
  GeomList geoms;
  GlResources resources;
  TextureFilter filter;
  mjvOption options;
  mjvCamera free_camera;
  std::vector<std::uint8_t> bottom_up;
};

Renderer::Renderer(const mjModel_& model, const PinholeView& view, std::unique_ptr<GlContext> context)
    : view_(view),
      image_(view.width_px, view.height_px),
      impl_(std::make_unique<Impl>(model, view, std::move(context))) {}

Renderer::~Renderer() { impl_->gl->MakeCurrent(); }

const models::Image& Renderer::Render(mjData_& data, const Eigen::Isometry3d& X_WC) {
  Impl& impl = *impl_;
  impl.gl->MakeCurrent();
  const std::optional<FloorFootprint> footprint = FootprintOf(view_, X_WC);
  impl.options.geomgroup[kSurroundings] = footprint && LiesOnTheFloorsCentre(*footprint) ? 0 : 1;
  impl.filter.SuitTo(footprint, view_.focal_px);
  mjv_updateScene(&impl.model, &data, &impl.options, nullptr, &impl.free_camera, mjCAT_ALL, &impl.geoms);
  impl.geoms.camera[0] = impl.geoms.camera[1] = CameraFor(view_, X_WC);
  const mjrRect viewport{0, 0, view_.width_px, view_.height_px};
  mjr_render(viewport, &impl.geoms, &impl.resources);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, view_.width_px, view_.height_px, GL_RED, GL_UNSIGNED_BYTE, impl.bottom_up.data());
  const std::uint8_t* source = impl.bottom_up.data();
  for (int v = view_.height_px - 1; v >= 0; --v, source += view_.width_px) {
    std::copy_n(source, view_.width_px, image_.Row(v));
  }
  return image_;
}

}  // namespace touchdown::sim
