#include "sim/render/camera_optics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "models/error.h"
#include "models/pose_interpolation.h"

namespace touchdown::sim {
namespace {

constexpr double kOne = 1 << PackedImage::kFractionBits;
constexpr int kCell_px = 64;
constexpr int kMargin_px = 4;
constexpr int kMaxView_px = 4096;
constexpr double kStill_px = 0.25;
constexpr double kTapSpacing_px = 1.0;

std::int32_t ToFixed(double value) { return static_cast<std::int32_t>(std::lround(value * kOne)); }

}  // namespace

Eigen::Isometry3d PoseAlong(ExposurePath X_WC, double fraction) {
  const double index = fraction * static_cast<double>(X_WC.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(index), X_WC.size() - 1);
  const auto after = std::min(before + 1, X_WC.size() - 1);
  const double weight = index - static_cast<double>(before);
  if (weight == 0.0) return X_WC[before];
  return models::InterpolatePose(X_WC[before], X_WC[after], weight);
}

CameraOptics::CameraOptics(const models::CameraModel& camera) : width_(camera.width_px), height_(camera.height_px) {
  camera.Validate();
  grid_columns_ = (width_ + kCell_px - 1) / kCell_px + 1;
  grid_rows_ = (height_ + kCell_px - 1) / kCell_px + 1;
  MakeLookups(camera);
  frame_ = {width_, height_, std::vector<std::uint16_t>(lookups_x_.size())};
}

void CameraOptics::MakeLookups(const models::CameraModel& camera) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  view_.focal_px = std::max(camera.fx_px, camera.fy_px);
  const Eigen::Vector2d center(camera.cx_px, camera.cy_px);
  Eigen::Vector2d least = center, most = center;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const auto ideal = camera.Undistort(camera.NormalizedFromPixel({u, v}));
      if (!ideal) throw InputError("camera: the lens distortion is not invertible within the image");
      points.push_back(view_.focal_px * *ideal + center);
      least = least.cwiseMin(points.back());
      most = most.cwiseMax(points.back());
    }
  }
  const Eigen::Vector2d origin = least.array().floor() - kMargin_px;
  const Eigen::Vector2d size = most.array().ceil() + (kMargin_px + 1) - origin.array();
  if (!(size.maxCoeff() <= kMaxView_px)) {
    throw InputError("camera: the lens needs a rendered view of more than " + std::to_string(kMaxView_px) + " px");
  }
  view_.width_px = static_cast<int>(size.x());
  view_.height_px = static_cast<int>(size.y());
  view_.cx_px = center.x() - origin.x();
  view_.cy_px = center.y() - origin.y();
  for (const Eigen::Vector2d& point : points) {
    lookups_x_.push_back(ToFixed(point.x() - origin.x()));
    lookups_y_.push_back(ToFixed(point.y() - origin.y()));
  }
}

Eigen::Vector2d CameraOptics::LookupOf(int u, int v) const {
  const auto i = static_cast<std::size_t>(v * width_ + u);
  return Eigen::Vector2d(lookups_x_[i], lookups_y_[i]) / kOne;
}

int CameraOptics::NodeColumn(int i) const { return std::min(i * kCell_px, width_ - 1); }
int CameraOptics::NodeRow(int j) const { return std::min(j * kCell_px, height_ - 1); }

Eigen::Vector2d CameraOptics::ShiftAt(const Eigen::Vector2d& pixel, const Eigen::Isometry3d& X_WM,
                                      const Eigen::Isometry3d& X_WS) const {
  const Eigen::Vector2d center(view_.cx_px, view_.cy_px);
  const Eigen::Vector2d ray = (pixel - center) / view_.focal_px;
  const Eigen::Vector3d ray_W = X_WS.linear() * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
  const double height = X_WS.translation().z();
  // Point where the ray meets the floor, divided by its depth. A ray to or above the horizon has inverse depth 0: only
  // the rotation shifts it.
  const double inverse_depth = height > 0.0 ? std::max(0.0, -ray_W.z()) / height : 0.0;
  const Eigen::Vector3d point_M =
      X_WM.linear().transpose() * (ray_W + inverse_depth * (X_WS.translation() - X_WM.translation()));
  if (point_M.z() <= 0.0) return Eigen::Vector2d::Zero();
  return view_.focal_px * point_M.head<2>() / point_M.z() + center - pixel;
}

CameraOptics::ShiftGrid CameraOptics::ShiftsBetween(const Eigen::Isometry3d& X_WM,
                                                    const Eigen::Isometry3d& X_WS) const {
  ShiftGrid shifts;
  shifts.reserve(static_cast<std::size_t>(grid_columns_) * static_cast<std::size_t>(grid_rows_));
  for (int j = 0; j < grid_rows_; ++j) {
    for (int i = 0; i < grid_columns_; ++i) {
      const Eigen::Vector2d shift = ShiftAt(LookupOf(NodeColumn(i), NodeRow(j)), X_WM, X_WS);
      const double limit = kMaxView_px;
      shifts.emplace_back(ToFixed(std::clamp(shift.x(), -limit, limit)), ToFixed(std::clamp(shift.y(), -limit, limit)));
    }
  }
  return shifts;
}

int CameraOptics::TapsFor(ExposurePath X_WC) const {
  double longest = 0.0;
  for (const int v : {0, height_ / 2, height_ - 1}) {
    for (const int u : {0, width_ / 2, width_ - 1}) {
      const Eigen::Vector2d pixel = LookupOf(u, v);
      double length = 0.0;
      for (std::size_t i = 1; i < X_WC.size(); ++i) length += ShiftAt(pixel, X_WC[i - 1], X_WC[i]).norm();
      longest = std::max(longest, length);
    }
  }
  if (longest <= kStill_px) return 1;
  return static_cast<int>(std::clamp(std::ceil(longest / kTapSpacing_px), 2.0, static_cast<double>(kMaxTaps)));
}

void CameraOptics::AddRow(const ShiftGrid& shifts, int v, std::uint32_t* sums) const {
  const int cell_row = v / kCell_px;
  const int rows = std::max(1, NodeRow(cell_row + 1) - NodeRow(cell_row)), down = v - NodeRow(cell_row);
  const auto shift_at = [&](int i) -> Vector2i {
    const Vector2i& upper = shifts[static_cast<std::size_t>(cell_row * grid_columns_ + i)];
    const Vector2i& lower = shifts[static_cast<std::size_t>((cell_row + 1) * grid_columns_ + i)];
    return upper + (lower - upper) / rows * down;
  };
  Vector2i left = shift_at(0);
  for (int i = 0; i + 1 < grid_columns_; ++i) {
    const Vector2i right = shift_at(i + 1);
    const int begin = i * kCell_px;
    const std::size_t first = static_cast<std::size_t>(v * width_ + begin);
    pinhole_.AddLookups({.x = &lookups_x_[first],
                         .y = &lookups_y_[first],
                         .count = std::min(kCell_px, width_ - begin),
                         .shift = left,
                         .step = (right - left) / std::max(1, NodeColumn(i + 1) - NodeColumn(i))},
                        sums + begin);
    left = right;
  }
}

const FineImage& CameraOptics::Expose(const models::Image& pinhole, ExposurePath X_WC) {
  const int taps = TapsFor(X_WC);
  const Eigen::Isometry3d X_WM = PoseAlong(X_WC, 0.5);
  std::vector<ShiftGrid> shifts;
  for (int i = 0; i < taps; ++i) {
    shifts.push_back(ShiftsBetween(X_WM, taps == 1 ? X_WM : PoseAlong(X_WC, (i + 0.5) / taps)));
  }
  pinhole_.Pack(pinhole);
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(width_));
  for (int v = 0; v < height_; ++v) {
    std::fill(sums.begin(), sums.end(), 0u);
    for (const ShiftGrid& grid : shifts) AddRow(grid, v, sums.data());
    WriteMeans(sums, taps, frame_.pixels.data() + static_cast<std::ptrdiff_t>(v) * width_);
  }
  return frame_;
}

}  // namespace touchdown::sim
