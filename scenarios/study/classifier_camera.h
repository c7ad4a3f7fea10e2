#pragma once

#include <memory>

#include "models/camera_model.h"
#include "models/random_stream.h"
#include "models/signals.h"
#include "scenarios/study/classifier_views.h"
#include "sim/scene.h"

namespace touchdown::scenarios {

/// Takes frames of a scene from any place, by the means of the flight's camera: renderer, distortion, exposure blur,
/// noise; and, beside them, lens blur and weak contrast.
class SceneCamera {
 public:
  /// Builds the scene's model and its GL context. Throws std::runtime_error when there is no context.
  SceneCamera(const sim::Scene& scene, const models::CameraModel& camera);
  ~SceneCamera();
  SceneCamera(const SceneCamera&) = delete;
  SceneCamera& operator=(const SceneCamera&) = delete;

  /// The frame of `view`; its noise is drawn from `random`.
  models::Image Take(const View& view, models::RandomStream& random);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::scenarios
