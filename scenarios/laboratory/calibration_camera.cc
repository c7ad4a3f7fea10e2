#include "scenarios/laboratory/calibration_camera.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "sim/dynamics/mujoco_model.h"
#include "sim/render/camera_optics.h"
#include "sim/render/renderer.h"
#include "sim/sensors/image_noise.h"

namespace touchdown::laboratory {
namespace {

constexpr int kFiner = 4;
constexpr int kWidestView_px = 8192;

/// How many times finer a view of that size is rendered.
int FinerBy(const sim::PinholeView& view) {
  return std::clamp(kWidestView_px / std::max(view.width_px, view.height_px), 1, kFiner);
}

/// The same view on a grid that has `finer` x `finer` pixels for one.
sim::PinholeView Finer(const sim::PinholeView& view, int finer) {
  const auto scaled = [finer](double centre_px) { return finer * (centre_px + 0.5) - 0.5; };
  return {.width_px = finer * view.width_px,
          .height_px = finer * view.height_px,
          .focal_px = finer * view.focal_px,
          .cx_px = scaled(view.cx_px),
          .cy_px = scaled(view.cy_px)};
}

}  // namespace

struct ChessboardCamera::Impl {
  Impl(const Chessboard& board, const Eigen::Isometry3d& X_WE, const sim::CameraConfig& camera, std::uint64_t seed)
      : model(sim::LoadModel(ChessboardMjcf(board, X_WE))),
        data(sim::MakeData(*model)),
        optics(camera.model),
        renderer(*model, Finer(optics.pinhole_view(), FinerBy(optics.pinhole_view()))),
        noise(camera.noise_sigma, seed) {}

  sim::MujocoModel model;
  sim::MujocoData data;
  sim::CameraOptics optics;
  sim::Renderer renderer;
  sim::ImageNoise noise;
};

ChessboardCamera::ChessboardCamera(const Chessboard& board, const Eigen::Isometry3d& X_WE,
                                   const sim::CameraConfig& camera, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(board, X_WE, camera, seed)) {}

ChessboardCamera::~ChessboardCamera() = default;

models::Image ChessboardCamera::Take(const Eigen::Isometry3d& X_WC) {
  const models::Image& fine = impl_->renderer.Render(*impl_->data, X_WC);
  const sim::PinholeView& view = impl_->optics.pinhole_view();
  models::Image pinhole(view.width_px, view.height_px);
  const cv::Mat1b from(fine.height, fine.width, const_cast<std::uint8_t*>(fine.pixels.data()));
  cv::Mat1b to(pinhole.height, pinhole.width, pinhole.pixels.data());
  cv::resize(from, to, to.size(), 0.0, 0.0, cv::INTER_AREA);
  const std::array<Eigen::Isometry3d, 1> at_rest{X_WC};
  return impl_->noise.Apply(impl_->optics.Expose(pinhole, at_rest));
}

}  // namespace touchdown::laboratory
