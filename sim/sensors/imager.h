#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/signals.h"
#include "sim/render/camera_optics.h"
#include "sim/render/renderer.h"
#include "sim/sensors/image_noise.h"

namespace touchdown::sim {

/// A camera without a vehicle: renders the scene of a model from any pose, exposes it through the lens, and adds noise.
class Imager {
 public:
  /// `model` must outlive the imager. `noise_sigmas`, in gray levels of 0 to 255, are the available noise levels; each
  /// has its own generator, seeded with `seed`. With `oversampling` above 1 the pinhole view is rendered on a
  /// grid finer by that factor and averaged over the pixels, which antialiases the edges of solid shapes; the finer
  /// view is at most 8192 px wide. Throws InputError when a noise level is not valid, std::runtime_error when there is
  /// no GL context.
  Imager(const mjModel_& model, CameraOptics optics, const std::vector<double>& noise_sigmas, std::uint64_t seed,
         int oversampling = 1);

  /// Frame of an exposure along X_WC, with the first noise level. `data` must have its kinematics computed, as for
  /// Renderer::Render.
  models::Image Capture(mjData_& data, ExposurePath X_WC) { return AddNoise(Expose(data, X_WC)); }

  /// First step of Capture: the image on the sensor, without noise. Valid until the next call.
  const FineImage& Expose(mjData_& data, ExposurePath X_WC);

  /// Second step of Capture: adds noise, different in each call. Throws std::out_of_range for an unknown level.
  models::Image AddNoise(const FineImage& exposed, std::size_t noise_level = 0);

 private:
  CameraOptics optics_;
  Renderer renderer_;
  models::Image averaged_;  ///< The oversampled view, averaged to the grid of the optics; empty without oversampling.
  std::vector<ImageNoise> noises_;
};

}  // namespace touchdown::sim
