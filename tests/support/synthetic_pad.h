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

/// Appearance of the pad in a synthetic image. Gray values are 0 to 255.
struct PadAppearance {
  double black = 25.0;
  double paper = 215.0;
  double floor = 120.0;
  double noise_sigma = 0.0;
  double lens_blur_sigma_px = 0.0;  ///< Standard deviation of a Gaussian blur.
  int samples_per_side = 6;         ///< Subsamples per pixel in each direction, which are averaged.
  bool ring = true;
  bool letter = true;
  bool sheet = true;
  /// Overrides the gray value at a point of the floor, in W, on or around the pad; nullopt keeps the gray value of the
  /// pad. May be null.
  std::function<std::optional<double>(const Eigen::Vector2d& p_W)> paint = nullptr;
};

/// X_WC of a camera that looks straight down from `p_WC`, with the image's up direction rotated left by `yaw` from X_W,
/// and then tilted by `tilt` about the horizontal axis at `tilt_direction` from X_W (right-handed). Angles in rad.
Eigen::Isometry3d CameraAbovePad(const Eigen::Vector3d& p_WC, double yaw = 0.0, double tilt = 0.0,
                                 double tilt_direction = 0.0);

/// R_BC of the default mounting: the camera looks down, with the top of the image towards body forward.
Eigen::Matrix3d NominalR_BC();

/// Image of the pad by ray casting onto its plane. Each pixel is the mean over its square. The code is independent of
/// sim/. `random` provides the noise; it may be null without noise.
models::Image RenderPad(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC,
                        const PadAppearance& appearance = {}, models::RandomStream* random = nullptr);

/// Clutter for PadAppearance::paint: bars, checkerboards, lone circles and lone Hs on the floor, outside the sheet.
std::function<std::optional<double>(const Eigen::Vector2d&)> Clutter(const models::LandingPad& pad, std::uint64_t seed);

/// Unit vector pointing down, in the body frame.
inline Eigen::Vector3d GravityIn(const Eigen::Isometry3d& X_WB) { return -X_WB.linear().row(2).transpose(); }

}  // namespace touchdown::tests
