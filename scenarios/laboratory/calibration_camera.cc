#include "scenarios/laboratory/calibration_camera.h"

#include <array>

#include "sim/dynamics/mujoco_model.h"
#include "sim/sensors/imager.h"

namespace touchdown::laboratory {
namespace {

constexpr int kOversampling = 4;

}  // namespace

struct ChessboardCamera::Impl {
  Impl(const Chessboard& board, const Eigen::Isometry3d& X_WE, const sim::CameraConfig& camera, std::uint64_t seed)
      : model(sim::LoadModel(ChessboardMjcf(board, X_WE))),
        data(sim::MakeData(*model)),
        imager(*model, sim::CameraOptics(camera.model), {camera.noise_sigma}, seed, kOversampling) {}

  sim::MujocoModel model;
  sim::MujocoData data;
  sim::Imager imager;
};

ChessboardCamera::ChessboardCamera(const Chessboard& board, const Eigen::Isometry3d& X_WE,
                                   const sim::CameraConfig& camera, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(board, X_WE, camera, seed)) {}

ChessboardCamera::~ChessboardCamera() = default;

models::Image ChessboardCamera::Capture(const Eigen::Isometry3d& X_WC) {
  return impl_->imager.Capture(*impl_->data, std::array{X_WC});
}

}  // namespace touchdown::laboratory
