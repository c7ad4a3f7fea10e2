#pragma once

#include <cstdint>

#include "models/camera_model.h"
#include "models/signals.h"
#include "sim/render/camera_optics.h"
#include "sim/render/renderer.h"
#include "sim/sensors/image_noise.h"

namespace touchdown::sim {

/// A camera without a vehicle: renders the scene of a model, exposes it through the lens, adds noise. Any view of the
/// room can be taken with it.
class Imager {
 public:
  /// `model` must outlive it. Throws InputError when the camera or the noise is not valid.
  Imager(const mjModel_& model, const models::CameraModel& camera, double noise_sigma, std::uint64_t seed);

  /// The frame of an exposure along X_WC. `data` must have its kinematics computed, as for Renderer::Render.
  models::Image Expose(mjData_& data, ExposurePath X_WC);

 private:
  CameraOptics optics_;
  Renderer renderer_;
  ImageNoise noise_;
};

}  // namespace touchdown::sim
