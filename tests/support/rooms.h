#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "models/angles.h"
#include "models/signals.h"
#include "models/vehicle.h"
#include "sim/dynamics/mujoco_model.h"
#include "sim/scene/scene.h"
#include "tests/support/empty_room.h"

namespace touchdown::tests {

/// Scene with its MuJoCo model and painted textures, ready to be rendered. The vehicle is out of view.
struct Room {
  explicit Room(const sim::SceneConfig& config = {}, std::uint64_t seed = 1)
      : scene(sim::MakeScene(config, models::LandingPad{}, seed)) {
    constexpr const char* kParked = "<body name='parked' pos='0 0 3'><freejoint/><geom size='0.1' group='2'/></body>";
    model = sim::LoadModel(sim::SceneMjcf(scene, kParked, 1.0 / 1200.0));
    sim::PaintTextures(scene, *model);
    data = sim::MakeData(*model);
  }

  sim::Scene scene;
  sim::MujocoModel model;
  sim::MujocoData data;
};

/// X_WC of a camera. At zero angles it looks straight down, with the top of the image towards X_W.
inline Eigen::Isometry3d CameraAt(const Eigen::Vector3d& p_WC, const models::TaitBryan& tilt = {}) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan(tilt);
  models::Vehicle vehicle;
  vehicle.camera = {};
  Eigen::Isometry3d X_WC = X_WB * vehicle.X_BC();
  X_WC.translation() = p_WC;
  return X_WC;
}

/// Bilinearly interpolated gray value at a position in the image, px.
inline double GrayAt(const models::Image& image, const Eigen::Vector2d& pixel) {
  const int u = static_cast<int>(std::floor(pixel.x())), v = static_cast<int>(std::floor(pixel.y()));
  const double wu = pixel.x() - u, wv = pixel.y() - v;
  const models::ImageView view = image.View();
  return (1 - wv) * ((1 - wu) * view.At(u, v) + wu * view.At(u + 1, v)) +
         wv * ((1 - wu) * view.At(u, v + 1) + wu * view.At(u + 1, v + 1));
}

/// X_WC of a camera that looks at a point on the floor, rotated by `yaw` with respect to CameraAt.
inline Eigen::Isometry3d CameraTowards(const Eigen::Vector3d& p_WC, const Eigen::Vector2d& target, double yaw) {
  Eigen::Isometry3d X_WC = CameraAt(p_WC, {.roll = 0.0, .pitch = 0.0, .yaw = yaw});
  const Eigen::Vector3d line_of_sight = Eigen::Vector3d(target.x(), target.y(), 0.0) - p_WC;
  X_WC.linear() = models::ShortestRotation(-Eigen::Vector3d::UnitZ(), line_of_sight.normalized()) * X_WC.linear();
  return X_WC;
}

/// Offset of an edge of the image from the point `edge` along the unit vector `direction`, px. `edge` must be within 1
/// px of the edge, and the image uniform from 1 to 4 px on both sides. The result is the position of a sharp edge with
/// the same area, which is exact for any symmetric blur and sub-pixel position.
inline double EdgeOffset(const models::Image& image, const Eigen::Vector2d& edge, const Eigen::Vector2d& direction) {
  constexpr double kReach = 3.0, kStep = 0.01;
  const auto level = [&](double offset) { return GrayAt(image, edge + offset * direction); };
  const double behind = 0.5 * (level(-kReach) + level(-kReach - 1.0)),
               ahead = 0.5 * (level(kReach) + level(kReach + 1.0));
  double area = 0.0;
  for (double offset = -kReach + 0.5 * kStep; offset < kReach; offset += kStep)
    area += kStep * (level(offset) - behind);
  return kReach - area / (ahead - behind);
}

}  // namespace touchdown::tests
