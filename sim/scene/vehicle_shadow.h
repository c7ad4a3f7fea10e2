#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "sim/scene/ground_shade.h"

namespace touchdown::sim {

/// Shadow of the vehicle on the ground, in the light of a model's sun (kSunName).
///
/// Overlapping parts, and the painted shadows of solid items, darken the ground once. A spinning rotor blocks the
/// fraction of the light that its blades cover. The penumbra corresponds to the size of the sun. Solid items and
/// walls receive no shadow.
class VehicleShadow {
 public:
  explicit VehicleShadow(const mjModel& model);

  /// Shade of the vehicle at its pose in `data`, whose kinematics must be computed; valid until the next call. Returns
  /// nullptr without a sun that casts shadows.
  const GroundShade* Cast(const mjData& data);

 private:
  struct Part {
    int geom;
    std::uint8_t opacity;
  };
  using Outline = std::vector<Eigen::Vector2d>;

  Outline OutlineOf(const mjData& data, int geom) const;
  void FitSquare(const std::vector<Outline>& outlines, double blur_m);

  const mjModel& model_;
  std::optional<Eigen::Vector3d> to_sun_;
  double shade_ = 1.0;
  std::vector<Part> parts_;  ///< Transparent parts come first.
  std::vector<int> solids_;  ///< Geoms whose shadows are painted into the ground.
  cv::Mat1b mask_;
  GroundShade cast_;
};

}  // namespace touchdown::sim
