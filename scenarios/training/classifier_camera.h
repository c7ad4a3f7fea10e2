#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "models/signals.h"
#include "scenarios/training/classifier_views.h"
#include "sim/render/camera_optics.h"
#include "sim/scene/scene.h"

namespace touchdown::training {

/// Renders frames of a scene from any pose with the imager of a flight (renderer, distortion, exposure blur and noise),
/// plus defocus, contrast and brightness.
class SceneCamera {
 public:
  /// Builds the model of the scene and its GL context. `noise_sigmas` (of 255) are the values that View::noise_level
  /// selects from. `seed` is the seed of the noise. Throws std::runtime_error when no GL context is available.
  SceneCamera(const sim::Scene& scene, const sim::CameraOptics& optics, std::span<const double> noise_sigmas,
              std::uint64_t seed);
  ~SceneCamera();
  SceneCamera(const SceneCamera&) = delete;
  SceneCamera& operator=(const SceneCamera&) = delete;

  models::Image Capture(const View& view);
  /// Renders the last view again with new noise. Throws std::logic_error when there is no last view.
  models::Image CaptureAgain();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::training
