#include "tests/support/photo_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/angles.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using models::kPi;
using models::RandomStream;

/// X_WC of a camera that views the origin of W at `obliquity` along `ray_C`.
Eigen::Isometry3d CameraAimedAt(const Vector3d& ray_C, double distance, double obliquity, RandomStream& random) {
  const double azimuth = random.Uniform(-kPi, kPi), roll = random.Uniform(-kPi, kPi);
  const Vector3d from_W(std::sin(obliquity) * std::cos(azimuth), std::sin(obliquity) * std::sin(azimuth),
                        std::cos(obliquity));
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() = Eigen::Quaterniond::FromTwoVectors(ray_C, -from_W).toRotationMatrix() *
                  Eigen::AngleAxisd(roll, ray_C).toRotationMatrix();
  X_WC.translation() = distance * from_W;
  return X_WC;
}

/// Bounding box of the outer boundary of the ring; empty when part of it cannot be projected.
cv::Rect2d RingBox(const models::CameraModel& camera, const Eigen::Isometry3d& X_WC, const PhotoPaper& paper,
                   double radius_m) {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
  const Eigen::Isometry3d X_CW = X_WC.inverse();
  for (int i = 0; i < 180; ++i) {
    const double angle = 2.0 * kPi * i / 180.0;
    const Vector2d on_sheet = radius_m * Vector2d(std::cos(angle), std::sin(angle));
    Vector2d p_W = on_sheet;
    for (int n = 0; n < 5; ++n) p_W += on_sheet - paper.SheetPoint(p_W);
    const auto pixel = camera.Project(X_CW * Vector3d(p_W.x(), p_W.y(), paper.Height(p_W)));
    if (!pixel) return {};
    low = low.min(pixel->array());
    high = high.max(pixel->array());
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace

models::CameraModel DrawCamera(RandomStream& random) {
  static constexpr std::array<std::array<int, 2>, 9> kSizes = {
      {{320, 240}, {640, 480}, {640, 480}, {480, 640}, {752, 480}, {800, 600}, {1280, 720}, {960, 1280}, {2000, 1500}}};
  static constexpr std::array<double, 9> kCumulativeProbability = {0.12, 0.30, 0.48, 0.58, 0.70, 0.82, 0.91, 0.96, 1.0};
  const double draw = random.Uniform();
  const auto size = static_cast<std::size_t>(
      std::upper_bound(kCumulativeProbability.begin(), kCumulativeProbability.end() - 1, draw) -
      kCumulativeProbability.begin());
  models::CameraModel camera;
  camera.width_px = kSizes[size][0];
  camera.height_px = kSizes[size][1];
  const double long_side = std::max(camera.width_px, camera.height_px);
  camera.fx_px = camera.fy_px = long_side * random.Uniform(0.6, 1.15);
  camera.cx_px = 0.5 * (camera.width_px - 1) + 0.01 * long_side * random.Normal();
  camera.cy_px = 0.5 * (camera.height_px - 1) + 0.01 * long_side * random.Normal();
  camera.k1 = random.Bernoulli(0.3) ? 0.0 : random.Uniform(-0.15, 0.08);
  camera.k2 = random.Bernoulli(0.3) ? 0.0 : random.Uniform(0.0, 0.02);
  return camera;
}

PhotoView DrawView(const models::CameraModel& camera, const PhotoPaper& paper, double radius_m, double size_fraction,
                   double obliquity, RandomStream& random) {
  const double margin = 0.025 * std::min(camera.width_px, camera.height_px);
  for (double reach = 0.42;; reach *= 0.97) {
    const Vector2d pixel((0.5 + random.Uniform(-reach, reach)) * camera.width_px,
                         (0.5 + random.Uniform(-reach, reach)) * camera.height_px);
    const auto ray_C = camera.Ray(pixel);
    if (!ray_C) continue;
    const RandomStream orientation(random.Bits(), "photo.turn");
    PhotoView view;
    cv::Rect2d& box = view.ring_box;
    double distance = camera.fx_px * 2.0 * radius_m / (size_fraction * camera.height_px);
    for (int n = 0; n < 4; ++n) {
      RandomStream same_draws = orientation;
      view.X_WC = CameraAimedAt(*ray_C, distance, obliquity, same_draws);
      box = RingBox(camera, view.X_WC, paper, radius_m);
      if (box.empty()) break;
      const double ratio = box.height / (size_fraction * camera.height_px);
      if (n < 3) distance = std::max(distance * ratio, 1.6 * radius_m);
    }
    const bool is_whole = !box.empty() && box.x >= margin && box.y >= margin &&
                          box.br().x <= camera.width_px - margin && box.br().y <= camera.height_px - margin;
    if (is_whole) return view;
  }
}

}  // namespace touchdown::tests
