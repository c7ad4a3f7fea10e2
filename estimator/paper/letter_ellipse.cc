#include "estimator/paper/letter_ellipse.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "models/angles.h"
#include "models/error.h"

namespace touchdown::estimator {
namespace {

using Eigen::Vector2d;

/// Points every millimetre along the outline of the H, in W.
std::vector<Vector2d> Outline(const models::LandingPad& pad) {
  const double x = pad.h_height_m / 2.0, y = pad.h_width_m / 2.0;
  const double bar_x = pad.h_stroke_m / 2.0, inner_y = y - pad.h_stroke_m;
  const std::vector<Vector2d> corners{
      {x, y},   {x, inner_y},   {bar_x, inner_y},   {bar_x, -inner_y}, {x, -inner_y}, {x, -y},
      {-x, -y}, {-x, -inner_y}, {-bar_x, -inner_y}, {-bar_x, inner_y}, {-x, inner_y}, {-x, y}};
  constexpr double kSpacing_m = 0.001;
  std::vector<Vector2d> outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d from = corners[i], side = corners[(i + 1) % corners.size()] - from;
    const int count = std::max(2, static_cast<int>(side.norm() / kSpacing_m));
    for (int k = 0; k < count; ++k) outline.push_back(from + side * (static_cast<double>(k) / count));
  }
  return outline;
}

Ellipse FittedTo(const models::LandingPad& pad) {
  pad.Validate();
  constexpr double kLeastElongation = 1.1;
  const auto ellipse = FitEllipse(Outline(pad));
  if (!ellipse || ellipse->semi_axes.x() < kLeastElongation * ellipse->semi_axes.y()) {
    throw InputError("the pad's H is too nearly as wide as high: its ellipse has no direction");
  }
  return *ellipse;
}

}  // namespace

LetterEllipse::LetterEllipse(const models::LandingPad& pad) : in_pad_(FittedTo(pad)) {}

double LetterEllipse::StrokeAngle(const Ellipse& seen) const {
  const bool major_axis_is_along_strokes = std::abs(std::cos(in_pad_.angle)) > std::abs(std::sin(in_pad_.angle));
  return major_axis_is_along_strokes ? seen.angle : models::WrapToHalfPi(seen.angle + models::kPi / 2.0);
}

std::optional<double> LetterEllipse::StrokeAngleSeenFrom(const Eigen::Isometry3d& X_CW) const {
  Eigen::Matrix3d image_from_plane;
  image_from_plane << X_CW.linear().leftCols<2>(), X_CW.translation();
  const Eigen::Matrix3d plane_from_image = image_from_plane.inverse();
  const auto seen = Ellipse::FromConic(plane_from_image.transpose() * in_pad_.Conic() * plane_from_image);
  if (!seen) return std::nullopt;
  return StrokeAngle(*seen);
}

}  // namespace touchdown::estimator
