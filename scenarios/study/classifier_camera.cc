#include "scenarios/study/classifier_camera.h"

#include <opencv2/imgproc.hpp>

#include "sim/mujoco_model.h"
#include "sim/renderer.h"

namespace touchdown::scenarios {

struct SceneCamera::Impl {
  Impl(const sim::Scene& scene, const models::CameraModel& camera)
      : model(sim::LoadModel(sim::SceneMjcf(scene, "", 1.0 / 1200.0))) {
    sim::PaintTextures(scene, *model);
    data = sim::MakeData(*model);
    renderer = std::make_unique<sim::Renderer>(
        *model, sim::PinholeView{camera.width_px, camera.height_px, camera.fx_px, camera.cx_px, camera.cy_px});
  }

  sim::MujocoModel model;
  sim::MujocoData data;
  std::unique_ptr<sim::Renderer> renderer;
};

SceneCamera::SceneCamera(const sim::Scene& scene, const models::CameraModel& camera)
    : impl_(std::make_unique<Impl>(scene, camera)) {}

SceneCamera::~SceneCamera() = default;

models::Image SceneCamera::Take(const View& view, models::RandomStream& random) {
  models::Image image = impl_->renderer->Render(*impl_->data, view.X_WC);
  cv::Mat1b pixels(image.height, image.width, image.pixels.data());
  if (view.defocus_px > 0.0) cv::GaussianBlur(pixels, pixels, {}, view.defocus_px);
  pixels.convertTo(pixels, CV_8U, view.contrast, view.brightness);
  for (auto& p : image.pixels) p = cv::saturate_cast<std::uint8_t>(p + view.noise_sigma * random.Normal());
  return image;
}

}  // namespace touchdown::scenarios
