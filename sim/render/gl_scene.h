#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/render/gl_context.h"
#include "sim/render/pinhole_view.h"
#include "sim/scene/ground_shade.h"

namespace touchdown::sim {

/// Draws a model with MuJoCo's renderer in a GL context of its own; the basis of every view of a scene. It draws
/// neither sky nor fog, and no shadows other than those passed to Draw.
class GlScene {
 public:
  enum class Pixels {
    kRed,  ///< The red channel alone, at a quarter of the bandwidth.
    kBgr,  ///< Blue, green, red: OpenCV's order.
  };

  /// Copies the model's textures into the GL context; `model` must outlive this object. Throws std::runtime_error when
  /// there is no buffer for a view of that size.
  GlScene(const mjModel& model, const PinholeView& view, Pixels pixels, std::unique_ptr<GlContext> context);
  /// Makes its context current, so that objects created in it can be destroyed.
  ~GlScene() { gl_->MakeCurrent(); }
  GlScene(const GlScene&) = delete;
  GlScene& operator=(const GlScene&) = delete;

  /// Call before any other member, and before any OpenGL function that uses objects of this context.
  void MakeCurrent() { gl_->MakeCurrent(); }

  /// MuJoCo's objects in the GL context.
  const mjrContext& resources() const { return resources_; }

  /// Fills the draw list with the geoms of the model that `options` selects. `data` must have its kinematics computed.
  void List(mjData& data, const mjvOption& options);
  /// Adds a geom that is not in the model to the draw list, at X_WG, with MuJoCo's size for its type.
  void Add(mjtGeom type, const Eigen::Vector3d& size_m, const Eigen::Isometry3d& X_WG, const Eigen::Vector4f& rgba);
  /// Draws the list from X_WC (frame C: X right, Y down, Z forward), darkens the ground by `shade` unless it is null,
  /// and writes the pixels, row 0 at the top, without padding between rows.
  void Draw(const Eigen::Isometry3d& X_WC, const GroundShade* shade, std::uint8_t* pixels);

 private:
  /// MuJoCo's draw list.
  struct GeomList : mjvScene {
    explicit GeomList(const mjModel& model);
    ~GeomList() { mjv_freeScene(this); }
    GeomList(const GeomList&) = delete;
    GeomList& operator=(const GeomList&) = delete;
  };
  /// MuJoCo's objects in the current GL context: textures and an off-screen buffer.
  struct Resources : mjrContext {
    Resources(const mjModel& model, const PinholeView& view);
    ~Resources() { mjr_freeContext(this); }
    Resources(const Resources&) = delete;
    Resources& operator=(const Resources&) = delete;
  };

  std::size_t bytes_per_px() const { return pixels_ == Pixels::kRed ? 1 : 3; }

  const mjModel& model_;
  PinholeView view_;
  Pixels pixels_;
  std::unique_ptr<GlContext> gl_;
  GeomList geoms_;
  Resources resources_;
  GroundShadePainter shade_painter_;
  std::vector<std::uint8_t> bottom_up_;
};

}  // namespace touchdown::sim
