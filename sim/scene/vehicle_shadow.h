#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "sim/scene/ground_shade.h"

namespace touchdown::sim {

/// The shadow of the vehicle on the ground, in the light of a model's sun (kSunName).
///
/// Parts that cover each other darken the ground once, and where a solid object's shadow is painted already, not again.
/// Turning rotors take the share of light that their blades cover. The edge is as soft as the sun is wide. Solid
/// objects and walls catch no shadow.
class VehicleShadow {
 public:
  explicit VehicleShadow(const mjModel& model);

  /// What the vehicle takes of the ground's light as it is in `data`, whose kinematics are computed; valid until the
  /// next call. Null when there is no sun that casts shadows.
  const GroundShade* Cast(const mjData& data);

 private:
  struct Part {
    int geom;
    std::uint8_t opacity;
  };
  using Outline = std::vector<Eigen::Vector2d>;

  Outline OutlineOf(const mjData& data, int geom) const;
  void Frame(const std::vector<Outline>& outlines, double blur_m);

  const mjModel& model_;
  std::optional<Eigen::Vector3d> to_sun_;
  double shade_ = 1.0;
  std::vector<Part> parts_;  ///< What lets light through comes first.
  std::vector<int> solids_;  ///< Geoms whose shadows are painted into the ground.
  cv::Mat1b mask_;
  GroundShade cast_;
};

}  // namespace touchdown::sim
