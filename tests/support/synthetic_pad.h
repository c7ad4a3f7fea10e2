#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <optional>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/random_stream.h"
#include "models/signals.h"

namespace touchdown::tests {

/// How a synthetic picture of the pad looks. Gray values are of 255.
struct PadPicture {
  double black = 25.0;
  double paper = 215.0;
  double floor = 120.0;
  double noise_sigma = 0.0;
  double lens_blur_sigma_px = 0.0;  ///< Gaussian.
  int samples_per_side = 6;         ///< Subsamples of a pixel, in each direction; their mean is its value.
  bool ring = true;
  bool letter = true;
  bool sheet = true;
  /// Gray value of a point of the floor's plane around and on the pad, in W, in place of the pad's own; nullopt leaves
  /// the pad's.
  std::function<std::optional<double>(const Eigen::Vector2d& p_W)> paint = nullptr;
};

/// Pose of a camera that looks straight down from `p_WC`, the image's up turned left by `yaw` from X_W, and then tilted
/// by `tilt` radians about the horizontal axis at `tilt_direction` from X_W (right-handed).
Eigen::Isometry3d CameraAbovePad(const Eigen::Vector3d& p_WC, double yaw = 0.0, double tilt = 0.0,
                                 double tilt_direction = 0.0);

/// R_BC of the default mounting: the camera looks down, the image's up towards body forward.
Eigen::Matrix3d NominalR_BC();

/// A picture of the pad by ray casting through `camera`, each pixel the mean over its own square, with the pad's plane
/// as the only thing in the world. Independent of sim/. Noise comes from `random`, which may be null without noise.
models::Image RenderPad(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC,
                        const PadPicture& picture = {}, models::RandomStream* random = nullptr);

/// Posters, bars, lone circles and lone Hs on the floor around the pad, for PadPicture::paint: the sheet stays free.
std::function<std::optional<double>(const Eigen::Vector2d&)> Clutter(const models::LandingPad& pad, std::uint64_t seed);

/// Unit vector pointing down, in the body frame.
inline Eigen::Vector3d GravityIn(const Eigen::Isometry3d& X_WB) { return -X_WB.linear().row(2).transpose(); }

}  // namespace touchdown::tests
