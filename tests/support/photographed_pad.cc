#include "tests/support/photographed_pad.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "models/angles.h"
#include "models/random_stream.h"
#include "tests/support/photo_artwork.h"
#include "tests/support/photo_floors.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using models::kPi;
using models::RandomStream;

constexpr int kCell_px = 8;  ///< Of the grid on which rays are cast; the pixels between are interpolated.

/// The paper's height over the table, bent about parallel lines only, as paper does. Lengths in the ring's radius.
class Paper {
 public:
  Paper(double radius_m, double severity, RandomStream& random) : radius_m_(radius_m) {
    const double heading = random.Uniform(-kPi, kPi);
    across_ = Vector2d(std::cos(heading), std::sin(heading));
    kind_ = severity > 0.0 ? random.UniformInt(0, 3) : 4;
    amount_ = severity * random.Uniform(0.4, 1.0) * (random.Chance(0.5) ? 1.0 : -1.0);
    phase_ = random.Uniform(-kPi, kPi);
    period_ = random.Uniform(2.0, 4.5);
    begin_ = random.Uniform(0.0, 1.0);
    double length = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      lengths_.push_back(length);
      const double slope = Slope(PlaceAt(i + 0.5));
      length += kStep * std::sqrt(1.0 + slope * slope);
    }
    const double zero = lengths_[kSteps / 2];
    for (double& each : lengths_) each -= zero;
  }

  double Height(const Vector2d& p_W) const { return radius_m_ * HeightAt(Along(p_W)); }

  Vector3d Normal(const Vector2d& p_W) const {
    const double slope = Slope(Along(p_W));
    return Vector3d(-slope * across_.x(), -slope * across_.y(), 1.0).normalized();
  }

  /// The sheet's own coordinates of the paper above a point of the table.
  Vector2d SheetPoint(const Vector2d& p_W) const {
    const double q = Along(p_W);
    const double index = std::clamp(q / kStep + kSteps / 2, 0.0, kSteps - 1.001);
    const auto i = static_cast<std::size_t>(index);
    const double length = lengths_[i] + (index - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
    return p_W + across_ * (radius_m_ * (length - q));
  }

  double LargestHeight() const {
    double largest = 0.0;
    for (double q = -1.0; q <= 1.0; q += 0.02) largest = std::max(largest, std::abs(HeightAt(q)));
    return largest;
  }

 private:
  static constexpr int kSteps = 1600;
  static constexpr double kStep = 0.005;

  static double PlaceAt(double index) { return (index - kSteps / 2) * kStep; }
  double Along(const Vector2d& p_W) const { return across_.dot(p_W) / radius_m_; }
  double Raw(double q) const {
    switch (kind_) {
      case 0:  // A roll that has been flattened.
        return amount_ * q * q;
      case 1:  // Waves.
        return 0.5 * amount_ * std::sin(2.0 * kPi * q / period_ + phase_);
      case 2:  // A side or corner that lifts.
        return q > begin_ ? 1.5 * std::abs(amount_) * (q - begin_) * (q - begin_) : 0.0;
      case 3:  // A crease.
        return amount_ * std::abs(q - 0.5 * begin_);
      default:
        return 0.0;
    }
  }
  double HeightAt(double q) const { return Raw(std::clamp(q, -2.0, 2.0)) - Raw(0.0); }
  double Slope(double q) const { return (HeightAt(q + 1e-3) - HeightAt(q - 1e-3)) / 2e-3; }

  double radius_m_, amount_ = 0.0, phase_ = 0.0, period_ = 1.0, begin_ = 0.0;
  int kind_ = 4;
  Vector2d across_;
  std::vector<double> lengths_;
};

models::CameraModel DrawCamera(RandomStream& random) {
  static constexpr std::array<std::array<int, 2>, 9> kSizes = {
      {{320, 240}, {640, 480}, {640, 480}, {480, 640}, {752, 480}, {800, 600}, {1280, 720}, {960, 1280}, {2000, 1500}}};
  static constexpr std::array<double, 9> kUntil = {0.12, 0.30, 0.48, 0.58, 0.70, 0.82, 0.91, 0.96, 1.0};
  const double draw = random.Uniform();
  const auto size = static_cast<std::size_t>(std::upper_bound(kUntil.begin(), kUntil.end() - 1, draw) - kUntil.begin());
  models::CameraModel camera;
  camera.width_px = kSizes[size][0];
  camera.height_px = kSizes[size][1];
  const double long_side = std::max(camera.width_px, camera.height_px);
  camera.fx_px = camera.fy_px = long_side * random.Uniform(0.6, 1.15);
  camera.cx_px = 0.5 * (camera.width_px - 1) + 0.01 * long_side * random.Normal();
  camera.cy_px = 0.5 * (camera.height_px - 1) + 0.01 * long_side * random.Normal();
  camera.k1 = random.Chance(0.3) ? 0.0 : random.Uniform(-0.15, 0.08);
  camera.k2 = random.Chance(0.3) ? 0.0 : random.Uniform(0.0, 0.02);
  return camera;
}

/// A camera that sees W's origin under `obliquity` at the pixel of `ray_C`.
Eigen::Isometry3d CameraThatSees(const Vector3d& ray_C, double distance, double obliquity, RandomStream& random) {
  const double azimuth = random.Uniform(-kPi, kPi), roll = random.Uniform(-kPi, kPi);
  const Vector3d from_W(std::sin(obliquity) * std::cos(azimuth), std::sin(obliquity) * std::sin(azimuth),
                        std::cos(obliquity));
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() = Eigen::Quaterniond::FromTwoVectors(ray_C, -from_W).toRotationMatrix() *
                  Eigen::AngleAxisd(roll, ray_C).toRotationMatrix();
  X_WC.translation() = distance * from_W;
  return X_WC;
}

/// The box of the ring's outer boundary; empty when part of it is not seen.
cv::Rect2d RingBox(const models::CameraModel& camera, const Eigen::Isometry3d& X_WC, const Paper& paper,
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

/// Puts the pad into the picture, whole, `size_share` of its height high.
void Aim(double size_share, const Paper& paper, RandomStream& random, Photograph& photo) {
  const models::CameraModel& camera = photo.camera;
  const double obliquity = models::DegToRad(photo.conditions.obliquity_deg);
  const double margin = 0.025 * std::min(camera.width_px, camera.height_px);
  for (double reach = 0.42;; reach *= 0.97) {
    const Vector2d pixel((0.5 + random.Uniform(-reach, reach)) * camera.width_px,
                         (0.5 + random.Uniform(-reach, reach)) * camera.height_px);
    const auto ray_C = camera.Ray(pixel);
    if (!ray_C) continue;
    RandomStream turn(random.Bits(), "photo.turn");
    const double radius = photo.pad.outer_radius_m;
    double distance = camera.fx_px * 2.0 * radius / (size_share * camera.height_px);
    for (int n = 0; n < 4; ++n) {
      RandomStream same = turn;
      photo.X_WC = CameraThatSees(*ray_C, distance, obliquity, same);
      photo.ring_box = RingBox(camera, photo.X_WC, paper, radius);
      if (photo.ring_box.empty()) break;
      const double grow = photo.ring_box.height / (size_share * camera.height_px);
      if (n < 3) distance = std::max(distance * grow, 1.6 * radius);
    }
    const cv::Rect2d& box = photo.ring_box;
    if (box.empty() || box.x < margin || box.y < margin || box.br().x > camera.width_px - margin ||
        box.br().y > camera.height_px - margin) {
      continue;
    }
    photo.center_px = camera.Project(photo.X_WC.inverse() * Vector3d::Zero()).value();
    photo.conditions.size_share = box.height / camera.height_px;
    return;
  }
}

/// Per pixel of the (supersampled) image: where on the sheet and on the floor it looks, and how the paper leans.
struct Views {
  cv::Mat2f sheet_m, floor_m;
  cv::Mat1f lambert;
};

cv::Mat Fine(const cv::Mat& coarse, cv::Size size) {
  cv::Mat fine;
  cv::resize(coarse, fine, coarse.size() * kCell_px, 0, 0, cv::INTER_LINEAR);
  return fine(cv::Rect({kCell_px, kCell_px}, size)).clone();
}

Views CastRays(const Photograph& photo, const Paper& paper, int samples, const Vector3d& to_light) {
  const cv::Size size(photo.camera.width_px * samples, photo.camera.height_px * samples);
  const cv::Size cells(size.width / kCell_px + 3, size.height / kCell_px + 3);
  cv::Mat2f sheet(cells), floor(cells);
  cv::Mat1f lambert(cells);
  const Eigen::Isometry3d& X_WC = photo.X_WC;
  for (int row = 0; row < cells.height; ++row) {
    for (int column = 0; column < cells.width; ++column) {
      const Vector2d fine((column - 1) * kCell_px + 0.5 * (kCell_px - 1), (row - 1) * kCell_px + 0.5 * (kCell_px - 1));
      const Vector2d pixel = (fine + Vector2d::Constant(0.5)) / samples - Vector2d::Constant(0.5);
      const auto ray_C = photo.camera.Ray(pixel);
      Vector3d ray_W = X_WC.linear() * ray_C.value_or(Vector3d::UnitZ());
      ray_W.z() = std::min(ray_W.z(), -0.02 * ray_W.norm());  // Beyond the horizon the floor goes on.
      const auto at_height = [&](double z) {
        return Vector2d((X_WC.translation() + ray_W * ((z - X_WC.translation().z()) / ray_W.z())).head<2>());
      };
      const Vector2d on_floor = at_height(0.0);
      Vector2d on_paper = on_floor;
      if (on_floor.norm() < 5.0 * photo.pad.outer_radius_m) {
        for (int n = 0; n < 14; ++n) on_paper = 0.5 * (on_paper + at_height(paper.Height(on_paper)));
      }
      const Vector2d on_sheet = paper.SheetPoint(on_paper);
      sheet(row, column) = {static_cast<float>(on_sheet.x()), static_cast<float>(on_sheet.y())};
      floor(row, column) = {static_cast<float>(on_floor.x()), static_cast<float>(on_floor.y())};
      lambert(row, column) = static_cast<float>(std::max(0.2, paper.Normal(on_paper).dot(to_light) / to_light.z()));
    }
  }
  return {Fine(sheet, size), Fine(floor, size), Fine(lambert, size)};
}

/// column = a_x * x + a_y * y + b of both coordinates, for cv::remap.
cv::Mat2f Mapped(const cv::Mat2f& points, const cv::Matx22f& A, const cv::Vec2f& b) {
  cv::Mat2f mapped;
  cv::transform(points, mapped, cv::Matx23f(A(0, 0), A(0, 1), b[0], A(1, 0), A(1, 1), b[1]));
  return mapped;
}

/// Reflectance, of 1, of all that the camera sees, and where the glossy toner is.
struct Surfaces {
  cv::Mat1f reflectance, toner;
};

Surfaces LookAt(const Photograph& photo, const Artwork& art, const Views& views, RandomStream& random) {
  const auto scale = static_cast<float>(art.px_per_m);
  const cv::Mat2f sheet_map =
      Mapped(views.sheet_m, {0.0F, -scale, -scale, 0.0F},
             {0.5F * static_cast<float>(art.ink.cols - 1), 0.5F * static_cast<float>(art.ink.rows - 1)});
  const double floor_scale = kFloorSide_px / (photo.pad.outer_radius_m * random.Uniform(8.0, 16.0));
  const double free_radius = 0.55 * std::hypot(photo.pad.sheet_length_m, photo.pad.sheet_width_m) * floor_scale;
  const cv::Mat1b floor = DrawFloor(photo.conditions.floor, free_radius, random);
  const double turn = random.Uniform(-kPi, kPi);
  const auto c = static_cast<float>(floor_scale * std::cos(turn)), s = static_cast<float>(floor_scale * std::sin(turn));
  const cv::Mat2f floor_map = Mapped(views.floor_m, {c, -s, s, c}, {kFloorSide_px / 2.0F, kFloorSide_px / 2.0F});

  cv::Mat1b ink, cover, ground;
  cv::remap(art.ink, ink, sheet_map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  const cv::Mat1b whole(art.ink.size(), photo.subject.starts_with("floor") ? 0 : 255);
  cv::remap(whole, cover, sheet_map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  cv::remap(floor, ground, floor_map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REFLECT_101);

  const double paper = random.Uniform(0.68, 0.9), toner = random.Uniform(0.035, 0.11);
  Surfaces result;
  cv::Mat1f covered, inked, grounded;
  cover.convertTo(covered, CV_32F, 1.0 / 255.0);
  ink.convertTo(inked, CV_32F, 1.0 / 255.0);
  ground.convertTo(grounded, CV_32F, 1.0 / 255.0);
  cv::pow(grounded, 2.2, grounded);
  // The paper's shadow on the floor beside it.
  cv::Mat1f shade;
  const int shift = std::max(1, ink.rows / 150);
  const cv::Mat move = (cv::Mat_<double>(2, 3) << 1, 0, shift, 0, 1, shift);
  cv::warpAffine(covered, shade, move, covered.size());
  cv::blur(shade, shade, {2 * shift + 1, 2 * shift + 1});
  grounded = grounded.mul(1.0 - 0.4 * shade);
  const cv::Mat1f sheet = paper - (paper - toner) * inked;
  result.reflectance = grounded + covered.mul(sheet - grounded);
  result.toner = inked.mul(covered);
  return result;
}

cv::Mat1f Blob(cv::Size size, const Vector2d& center, double radius_u, double radius_v, double angle) {
  constexpr int kReduce = 4;
  cv::Mat1f blob(size.height / kReduce + 1, size.width / kReduce + 1);
  const double c = std::cos(angle), s = std::sin(angle);
  for (int row = 0; row < blob.rows; ++row) {
    for (int column = 0; column < blob.cols; ++column) {
      const double du = kReduce * column - center.x(), dv = kReduce * row - center.y();
      const double a = (c * du + s * dv) / radius_u, b = (-s * du + c * dv) / radius_v;
      blob(row, column) = static_cast<float>(std::exp(-0.5 * (a * a + b * b)));
    }
  }
  cv::Mat1f fine;
  cv::resize(blob, fine, size, 0, 0, cv::INTER_LINEAR);
  return fine;
}

/// Light that falls on the scene, about 1: a slope, a lamp, and the shadow of something with an edge.
cv::Mat1f DrawLight(const Photograph& photo, cv::Size size, RandomStream& random) {
  const double slope = random.Uniform(0.0, 0.45), heading = random.Uniform(-kPi, kPi);
  cv::Mat1f coarse(size.height / 16 + 2, size.width / 16 + 2), light;
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.cols; ++column) {
      const double u = 2.0 * column / coarse.cols - 1.0, v = 2.0 * row / coarse.rows - 1.0;
      coarse(row, column) = static_cast<float>(1.0 + slope * (u * std::cos(heading) + v * std::sin(heading)));
    }
  }
  cv::resize(coarse, light, size, 0, 0, cv::INTER_LINEAR);
  if (random.Chance(0.4)) {
    const Vector2d at(random.Uniform(0.0, size.width), random.Uniform(0.0, size.height));
    const double radius = random.Uniform(0.25, 0.8) * size.width;
    light += random.Uniform(0.2, 0.9) * Blob(size, at, radius, radius, 0.0);
  }
  if (photo.conditions.shadow < 1.0) {
    const double scale = static_cast<double>(size.width) / photo.camera.width_px;
    const cv::Rect2d& box = photo.ring_box;
    const cv::Point2d through(scale * (box.x + random.Uniform(0.1, 0.9) * box.width),
                              scale * (box.y + random.Uniform(0.1, 0.9) * box.height));
    const double angle = random.Uniform(-kPi, kPi), reach = 3.0 * size.width;
    const cv::Point2d along(std::cos(angle), std::sin(angle)), away(-along.y, along.x);
    const double breadth = random.Chance(0.5) ? reach : scale * random.Uniform(0.15, 0.8) * box.width;
    cv::Mat1f shadow(size, 1.0F);
    std::vector<cv::Point> outline;
    for (const cv::Point2d& p : {through - reach * along, through + reach * along,
                                 through + reach * along + breadth * away, through - reach * along + breadth * away}) {
      outline.emplace_back(static_cast<int>(p.x), static_cast<int>(p.y));
    }
    cv::fillConvexPoly(shadow, outline, cv::Scalar(photo.conditions.shadow), cv::LINE_8);
    const double soft =
        scale * box.width * (random.Chance(0.5) ? random.Uniform(0.005, 0.02) : random.Uniform(0.02, 0.2));
    const int side = 2 * static_cast<int>(soft) + 1;
    cv::blur(shadow, shadow, {side, side});
    cv::blur(shadow, shadow, {side, side});
    light = light.mul(shadow);
  }
  return light;
}

/// The lamp's mirror image on toner and, weaker, on paper.
void AddGlare(const Photograph& photo, const cv::Mat1f& toner, RandomStream& random, cv::Mat1f& radiance) {
  if (photo.conditions.glare <= 0.0) return;
  const double scale = static_cast<double>(radiance.cols) / photo.camera.width_px;
  const cv::Rect2d& box = photo.ring_box;
  const int patches = random.UniformInt(1, 2);
  for (int i = 0; i < patches; ++i) {
    const Vector2d at(scale * (box.x + random.Uniform(0.0, 1.0) * box.width),
                      scale * (box.y + random.Uniform(0.0, 1.0) * box.height));
    const double radius = scale * std::max(box.width, box.height) * random.Uniform(0.05, 0.22);
    const cv::Mat1f blob =
        Blob(radiance.size(), at, radius, radius * random.Uniform(0.4, 1.0), random.Uniform(-kPi, kPi));
    radiance += photo.conditions.glare * blob.mul(0.35 + 0.65 * toner);
  }
}

void Defocus(cv::Mat1f& radiance, double radius_px) {
  if (radius_px < 0.3) return;
  const int reach = static_cast<int>(std::ceil(radius_px));
  cv::Mat1f kernel(2 * reach + 1, 2 * reach + 1);
  for (int v = -reach; v <= reach; ++v) {
    for (int u = -reach; u <= reach; ++u) {
      kernel(v + reach, u + reach) = static_cast<float>(std::clamp(radius_px + 0.5 - std::hypot(u, v), 0.0, 1.0));
    }
  }
  cv::filter2D(radiance, radiance, -1, kernel / cv::sum(kernel)[0]);
}

void SmearAlong(cv::Mat1f& radiance, double length_px, double angle) {
  if (length_px < 0.5) return;
  const int reach = static_cast<int>(std::ceil(0.5 * length_px)) + 1;
  cv::Mat1f kernel = cv::Mat1f::zeros(2 * reach + 1, 2 * reach + 1);
  constexpr int kSamples = 64;
  for (int i = 0; i < kSamples; ++i) {
    const double at = ((i + 0.5) / kSamples - 0.5) * length_px;
    const double u = at * std::cos(angle) + reach, v = at * std::sin(angle) + reach;
    const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
    const auto a = static_cast<float>(u - u0), b = static_cast<float>(v - v0);
    kernel(v0, u0) += (1 - a) * (1 - b);
    kernel(v0, u0 + 1) += a * (1 - b);
    kernel(v0 + 1, u0) += (1 - a) * b;
    kernel(v0 + 1, u0 + 1) += a * b;
  }
  cv::filter2D(radiance, radiance, -1, kernel / cv::sum(kernel)[0]);
}

/// Sensor and camera: vignette, exposure, noise, gamma, sharpening, JPEG.
cv::Mat1b Develop(const Photograph& photo, cv::Mat1f radiance, RandomStream& random) {
  const cv::Size size = radiance.size();
  const double vignette = random.Uniform(0.0, 0.45), haze = random.Chance(0.3) ? random.Uniform(0.0, 0.05) : 0.0;
  const double radius = 0.7 * std::hypot(size.width, size.height);
  radiance = radiance.mul(
      1.0 - vignette * (1.0 - Blob(size, {0.5 * size.width, 0.5 * size.height}, 0.6 * radius, 0.6 * radius, 0.0)));
  radiance = radiance * photo.conditions.exposure + haze;
  cv::min(radiance, 1.0, radiance);
  cv::max(radiance, 0.0, radiance);
  cv::pow(radiance, 1.0 / random.Uniform(1.7, 2.4), radiance);
  radiance *= 255.0;
  cv::Mat1f noise(size);
  cv::RNG rng(random.Bits());
  rng.fill(noise, cv::RNG::NORMAL, 0.0, photo.conditions.noise_sigma);
  if (random.Chance(0.5)) cv::blur(noise, noise, {2, 2});  // A camera that has smoothed its noise into blotches.
  radiance += noise;
  if (random.Chance(0.4)) {
    cv::Mat1f smooth;
    cv::GaussianBlur(radiance, smooth, {}, random.Uniform(0.8, 2.0));
    radiance += random.Uniform(0.3, 1.2) * (radiance - smooth);
  }
  cv::Mat1b image;
  radiance.convertTo(image, CV_8U);
  if (photo.conditions.jpeg_quality < 100) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, photo.conditions.jpeg_quality});
    image = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  }
  return image;
}

/// A share of the photographs is hard in each respect; few in more than three.
void DrawConditions(RandomStream& random, PhotoConditions& conditions) {
  const auto one_of = [&](const std::vector<std::string>& names) {
    return names[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(names.size()) - 1))];
  };
  conditions.obliquity_deg = random.Chance(0.3) ? random.Uniform(40.0, 60.0) : random.Uniform(0.0, 40.0);
  conditions.glare = random.Chance(0.25) ? random.Uniform(0.1, 0.9) : 0.0;
  conditions.shadow = random.Chance(0.3) ? random.Uniform(0.25, 0.8) : 1.0;
  conditions.exposure = random.Chance(0.15)   ? random.Uniform(0.12, 0.3)
                        : random.Chance(0.15) ? random.Uniform(1.0, 1.5)
                                              : random.Uniform(0.4, 0.9);
  conditions.noise_sigma = random.Chance(0.2) ? random.Uniform(4.0, 10.0) : random.Uniform(0.5, 4.0);
  conditions.jpeg_quality = random.Chance(0.6) ? random.UniformInt(35, 95) : 100;
  conditions.floor = one_of(FloorKinds());
  if (random.Chance(0.3)) conditions.marks = one_of(MarkKinds());
}

void Expose(const Artwork& art, const Paper& paper, RandomStream& random, Photograph& photo) {
  const models::CameraModel& camera = photo.camera;
  const int samples = camera.width_px * camera.height_px <= 500000 ? 2 : 1;
  const Vector3d to_light = Vector3d(random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8), 1.0).normalized();
  const Views views = CastRays(photo, paper, samples, to_light);
  const Surfaces surfaces = LookAt(photo, art, views, random);
  cv::Mat1f radiance =
      surfaces.reflectance.mul(DrawLight(photo, surfaces.reflectance.size(), random)).mul(views.lambert);
  AddGlare(photo, surfaces.toner, random, radiance);
  if (samples > 1) cv::resize(radiance, radiance, {camera.width_px, camera.height_px}, 0, 0, cv::INTER_AREA);

  // Blur that a person still reads the H through: up to a share of the narrowest stroke as seen.
  const double px_per_m = std::min(photo.ring_box.width, photo.ring_box.height) / (2.0 * photo.pad.outer_radius_m);
  const double narrowest_px = px_per_m * std::min(photo.pad.h_stroke_m, photo.pad.ring_width_m);
  const double most_px = std::max(0.6, 0.9 * narrowest_px);
  PhotoConditions& conditions = photo.conditions;
  const double scale = std::max(camera.width_px, camera.height_px) / 640.0;
  double defocus = random.Uniform(0.3, 0.7) * scale, motion = 0.0;
  if (random.Chance(0.25)) defocus = random.Uniform(0.7, 4.0) * scale;
  if (random.Chance(0.2)) motion = random.Uniform(1.0, 8.0) * scale;
  defocus = std::min(defocus, 0.5 * most_px);
  motion = std::min(motion, most_px);
  Defocus(radiance, defocus);
  SmearAlong(radiance, motion, random.Uniform(-kPi, kPi));
  conditions.blur_px = std::hypot(2.0 * defocus, motion);
  conditions.blur_share = conditions.blur_px / narrowest_px;

  cv::Mat1b developed = Develop(photo, std::move(radiance), random);
  photo.image = models::Image(camera.width_px, camera.height_px);
  developed.copyTo(cv::Mat1b(camera.height_px, camera.width_px, photo.image.pixels.data()));
}

Photograph Take(const std::string& subject, RandomStream& random) {
  Photograph photo;
  photo.subject = subject;
  photo.pad = DrawAnyPad(random);
  photo.camera = DrawCamera(random);
  DrawConditions(random, photo.conditions);
  if (subject != "pad") photo.conditions.marks = "none";
  if (subject.starts_with("floor ")) photo.conditions.floor = subject.substr(6);
  const Paper paper(photo.pad.outer_radius_m, random.Chance(0.3) ? random.Uniform(0.05, 0.25) : 0.0, random);
  photo.conditions.curl = paper.LargestHeight();
  // The narrowest stroke must be some pixels wide to be seen at all.
  const double stroke_share = std::min(photo.pad.h_stroke_m, photo.pad.ring_width_m) / (2.0 * photo.pad.outer_radius_m);
  const double tilt = std::cos(models::DegToRad(photo.conditions.obliquity_deg));
  const double least =
      std::max(0.06, 1.6 / (stroke_share * tilt * std::min(photo.camera.height_px, photo.camera.width_px)));
  const double most = 0.8 * std::min(1.0, 1.05 * photo.camera.width_px / photo.camera.height_px);
  Aim(std::exp(random.Uniform(std::log(std::min(least, 0.5 * most)), std::log(most))), paper, random, photo);

  const double px_per_m = photo.ring_box.width / (2.0 * photo.pad.outer_radius_m);
  Artwork art(photo.pad,
              (photo.camera.width_px <= 800 ? 2.0 : 1.2) * std::max(px_per_m, 60.0 / photo.pad.outer_radius_m));
  if (subject == "pad") {
    PrintPad(photo.pad, art);
    if (photo.conditions.marks != "none") PrintMarks(photo.pad, photo.conditions.marks, random, art);
  } else {
    PrintLookAlike(photo.pad, subject, random, art);
  }
  Expose(art, paper, random, photo);
  return photo;
}

}  // namespace

Photograph PhotographPad(std::uint64_t seed) {
  RandomStream random(seed, "photographs.pad");
  return Take("pad", random);
}

Photograph PhotographLookAlike(std::uint64_t seed) {
  RandomStream random(seed, "photographs.look_alike");
  return Take(LookAlikeKinds()[seed % LookAlikeKinds().size()], random);
}

}  // namespace touchdown::tests
