#include "scenarios/training/classifier_camera.h"

#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "sim/dynamics/mujoco_model.h"
#include "sim/sensors/imager.h"

namespace touchdown::training {
namespace {

constexpr double kTimestep_s = 1.0 / 1200.0;
constexpr double kFineLevels = 256.0;

sim::MujocoModel TexturedModel(const sim::Scene& scene) {
  sim::MujocoModel model = sim::LoadModel(sim::SceneMjcf(scene, "", kTimestep_s));
  sim::PaintTextures(scene, *model);
  return model;
}

}  // namespace

struct SceneCamera::Impl {
  Impl(const sim::Scene& scene, const sim::CameraOptics& optics, std::span<const double> noise_sigmas,
       std::uint64_t seed)
      : model(TexturedModel(scene)),
        data(sim::MakeData(*model)),
        imager(*model, optics, {noise_sigmas.begin(), noise_sigmas.end()}, seed) {}

  sim::MujocoModel model;
  sim::MujocoData data;
  sim::Imager imager;
  sim::FineImage exposed;  ///< Last view without noise.
  int noise_level = -1;    ///< Noise level of the last view; -1 before the first view.
};

SceneCamera::SceneCamera(const sim::Scene& scene, const sim::CameraOptics& optics, std::span<const double> noise_sigmas,
                         std::uint64_t seed)
    : impl_(std::make_unique<Impl>(scene, optics, noise_sigmas, seed)) {}

SceneCamera::~SceneCamera() = default;

models::Image SceneCamera::Capture(const View& view) {
  const double half_s = 0.5 * view.exposure_s;
  const std::array<Eigen::Isometry3d, 3> path{view.PoseAt(-half_s), view.X_WC, view.PoseAt(half_s)};
  sim::FineImage& frame = impl_->exposed;
  frame = impl_->imager.Expose(*impl_->data, path);
  cv::Mat_<std::uint16_t> levels(frame.height, frame.width, frame.pixels.data());
  if (view.defocus_px > 0.0) cv::GaussianBlur(levels, levels, {}, view.defocus_px);
  levels.convertTo(levels, CV_16U, view.contrast, view.brightness * kFineLevels);
  impl_->noise_level = view.noise_level;
  return CaptureAgain();
}

models::Image SceneCamera::CaptureAgain() {
  if (impl_->noise_level < 0) throw std::logic_error("CaptureAgain requires an earlier call of Capture");
  return impl_->imager.AddNoise(impl_->exposed, static_cast<std::size_t>(impl_->noise_level));
}

}  // namespace touchdown::training
