#include "tests/support/synthetic_pad.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/pad_outline.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool OnSheet(const models::LandingPad& pad, const Vector2d& p) {
  return std::abs(p.x()) <= pad.sheet_length_m / 2.0 && std::abs(p.y()) <= pad.sheet_width_m / 2.0;
}

double GrayAt(const models::LandingPad& pad, const models::PadOutline& outline, const PadAppearance& appearance,
              const Vector2d& p) {
  if (appearance.paint) {
    if (const auto painted = appearance.paint(p)) return *painted;
  }
  if (outline.IsBlack(p)) {
    const bool in_ring = p.norm() >= pad.inner_radius_m();
    if (in_ring ? appearance.ring : appearance.letter) return appearance.black;
  }
  return appearance.sheet && OnSheet(pad, p) ? appearance.paper : appearance.floor;
}

using Rays = std::vector<std::optional<Vector3d>>;

/// Rays in C through the corners of the pixels, in row-major order. Cached for the next image of the same camera.
const Rays& CornerRays(const models::CameraModel& camera) {
  thread_local std::optional<models::CameraModel> cached_for;
  thread_local Rays rays;
  if (cached_for != camera) {
    rays.clear();
    for (int v = 0; v <= camera.height_px; ++v) {
      for (int u = 0; u <= camera.width_px; ++u) rays.push_back(camera.Ray({u - 0.5, v - 0.5}));
    }
    cached_for = camera;
  }
  return rays;
}

/// Intersection of a ray with the floor.
std::optional<Vector2d> OnFloor(const Eigen::Isometry3d& X_WC, const std::optional<Vector3d>& ray_C) {
  if (!ray_C) return std::nullopt;
  const Vector3d ray_W = X_WC.linear() * *ray_C;
  if (ray_W.z() >= 0.0) return std::nullopt;
  const Vector3d hit = X_WC.translation() - ray_W * (X_WC.translation().z() / ray_W.z());
  return hit.head<2>();
}

/// Mean gray value over the square of a pixel, or the common gray value of its corners and its center. Floor points are
/// interpolated between the corners, with an error of about 1e-4 px. `corners` are the floor points of the corners, in
/// row-major order.
double PixelMean(const models::LandingPad& pad, const models::PadOutline& outline, const PadAppearance& appearance,
                 const std::array<std::optional<Vector2d>, 4>& corners) {
  for (const auto& corner : corners) {
    if (!corner) return appearance.floor;
  }
  const auto gray_at = [&](const Vector2d& p) { return GrayAt(pad, outline, appearance, p); };
  const double center = gray_at(0.25 * (*corners[0] + *corners[1] + *corners[2] + *corners[3]));
  if (std::all_of(corners.begin(), corners.end(), [&](const auto& corner) { return gray_at(*corner) == center; })) {
    return center;
  }
  const int n = appearance.samples_per_side;
  double sum = 0.0;
  for (int j = 0; j < n; ++j) {
    const double y = (j + 0.5) / n;
    const Vector2d left = (1.0 - y) * *corners[0] + y * *corners[2];
    const Vector2d right = (1.0 - y) * *corners[1] + y * *corners[3];
    for (int i = 0; i < n; ++i) {
      const double x = (i + 0.5) / n;
      sum += gray_at((1.0 - x) * left + x * right);
    }
  }
  return sum / (n * n);
}

void BlurRows(std::vector<double>& gray, int width, int height, const std::vector<double>& kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  std::vector<double> row(static_cast<std::size_t>(width));
  for (int v = 0; v < height; ++v) {
    double* pixels = gray.data() + static_cast<std::ptrdiff_t>(v) * width;
    for (int u = 0; u < width; ++u) {
      double sum = 0.0;
      for (int k = -radius; k <= radius; ++k) {
        sum += kernel[static_cast<std::size_t>(k + radius)] * pixels[std::clamp(u + k, 0, width - 1)];
      }
      row[static_cast<std::size_t>(u)] = sum;
    }
    std::copy(row.begin(), row.end(), pixels);
  }
}

std::vector<double> Transposed(const std::vector<double>& gray, int width, int height) {
  std::vector<double> result(gray.size());
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      result[static_cast<std::size_t>(u) * static_cast<std::size_t>(height) + static_cast<std::size_t>(v)] =
          gray[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
    }
  }
  return result;
}

void Blur(std::vector<double>& gray, int width, int height, double sigma_px) {
  const int radius = static_cast<int>(std::ceil(4.0 * sigma_px));
  std::vector<double> kernel;
  double sum = 0.0;
  for (int k = -radius; k <= radius; ++k) {
    kernel.push_back(std::exp(-0.5 * k * k / (sigma_px * sigma_px)));
    sum += kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  BlurRows(gray, width, height, kernel);
  gray = Transposed(gray, width, height);
  BlurRows(gray, height, width, kernel);
  gray = Transposed(gray, height, width);
}

}  // namespace

Eigen::Matrix3d NominalR_BC() {
  Eigen::Matrix3d R_BC;
  R_BC << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  return R_BC;
}

Eigen::Isometry3d CameraAbovePad(const Vector3d& p_WC, double yaw, double tilt, double tilt_direction) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  const Vector3d axis(std::cos(tilt_direction), std::sin(tilt_direction), 0.0);
  X_WC.linear() = Eigen::AngleAxisd(tilt, axis).toRotationMatrix() *
                  Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix() * NominalR_BC();
  X_WC.translation() = p_WC;
  return X_WC;
}

models::Image RenderPad(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC,
                        const PadAppearance& appearance, models::RandomStream* random) {
  const int width = camera.width_px, height = camera.height_px;
  const models::PadOutline outline(pad);
  std::vector<std::optional<Vector2d>> corners;
  for (const auto& ray_C : CornerRays(camera)) corners.push_back(OnFloor(X_WC, ray_C));
  std::vector<double> gray;
  for (int v = 0; v < height; ++v) {
    const auto upper = corners.begin() + static_cast<std::ptrdiff_t>(v) * (width + 1), lower = upper + (width + 1);
    for (int u = 0; u < width; ++u) {
      gray.push_back(PixelMean(pad, outline, appearance, {upper[u], upper[u + 1], lower[u], lower[u + 1]}));
    }
  }
  if (appearance.lens_blur_sigma_px > 0.0) Blur(gray, width, height, appearance.lens_blur_sigma_px);

  models::Image image(width, height);
  for (std::size_t i = 0; i < gray.size(); ++i) {
    const double noise = appearance.noise_sigma > 0.0 ? appearance.noise_sigma * random->Normal() : 0.0;
    image.pixels[i] = static_cast<std::uint8_t>(std::clamp(std::lround(gray[i] + noise), 0L, 255L));
  }
  return image;
}

std::function<std::optional<double>(const Vector2d&)> Clutter(const models::LandingPad& pad, std::uint64_t seed) {
  struct Item {
    Vector2d center;
    double angle, stretch, size, dark, light;
    int kind;
  };
  models::RandomStream random(seed, "tests.clutter");
  std::vector<Item> items;
  while (items.size() < 60) {
    Item item{{random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0)},
              random.Uniform(0.0, 2.0 * models::kPi),
              random.Uniform(0.6, 1.6),
              random.Uniform(0.05, 0.12),
              random.Uniform(10.0, 70.0),
              random.Uniform(130.0, 240.0),
              random.UniformInt(0, 4)};
    if (item.center.norm() > 0.4) items.push_back(item);
  }
  return [pad, items](const Vector2d& p) -> std::optional<double> {
    if (OnSheet(pad, p)) return std::nullopt;
    for (const Item& item : items) {
      constexpr double kReach = 1.3 * std::numbers::sqrt2 / 0.6;
      if ((p - item.center).squaredNorm() > std::pow(kReach * item.size, 2)) continue;
      Vector2d q = Eigen::Rotation2Dd(-item.angle) * (p - item.center);
      q.x() *= item.stretch;
      q /= item.size;
      if (q.cwiseAbs().maxCoeff() > 1.3) continue;
      bool is_dark = false;
      switch (item.kind) {
        case 0:  // Lone circle.
          is_dark = q.norm() < 1.0 && q.norm() > 0.8;
          break;
        case 1:  // Lone H.
          is_dark = std::abs(q.x()) < 1.0 && std::abs(q.y()) < 0.6 && (std::abs(q.y()) > 0.3 || std::abs(q.x()) < 0.16);
          break;
        case 2:  // Bars.
          is_dark = std::abs(q.x()) < 1.0 && std::fmod(q.y() + 10.0, 0.4) < 0.2;
          break;
        case 3:  // Checkerboard.
          is_dark = (static_cast<int>(std::floor(q.x() * 3.0)) + static_cast<int>(std::floor(q.y() * 3.0))) % 2 == 0;
          break;
        default:  // Disc with an off-center hole.
          is_dark = q.norm() < 1.0 && (q - Vector2d(0.3, 0.2)).norm() > 0.4;
      }
      return is_dark ? item.dark : item.light;
    }
    return std::nullopt;
  };
}

}  // namespace touchdown::tests
