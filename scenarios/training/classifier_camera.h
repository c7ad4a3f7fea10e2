#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "models/signals.h"
#include "scenarios/training/classifier_views.h"
#include "sim/render/camera_optics.h"
#include "sim/scene/scene.h"

namespace touchdown::training {

/// Takes frames of a scene from any place, with the flight's imager: renderer, distortion, exposure blur, noise; and,
/// beside them, lens blur and weak contrast.
class SceneCamera {
 public:
  /// Builds the scene's model and its GL context. `noise_sigmas`, of 255, are the levels of noise that
  /// View::noise_level chooses from; `seed` is the noise's. Throws std::runtime_error when there is no context.
  SceneCamera(const sim::Scene& scene, const sim::CameraOptics& optics, std::span<const double> noise_sigmas,
              std::uint64_t seed);
  ~SceneCamera();
  SceneCamera(const SceneCamera&) = delete;
  SceneCamera& operator=(const SceneCamera&) = delete;

  models::Image Capture(const View& view);
  /// Another frame of the view taken last, from which its noise alone tells it. Throws std::logic_error when there was
  /// none.
  models::Image CaptureAgain();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::training
