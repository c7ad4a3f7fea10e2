#include "estimator/paper/letter_ellipse.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "models/pad_outline.h"

namespace touchdown::estimator::paper {
namespace {

/// The ellipse fitted to the outline of the letter, in the plane of W, m.
pad::Ellipse FitLetter(const models::LandingPad& pad) {
  pad.Validate();
  constexpr double kSpacing_m = 0.001;
  const auto ellipse =
      pad::FitEllipse(models::PadOutline(pad).PointsAlongLetter(std::min(kSpacing_m, 0.1 * pad.h_stroke_m)));
  if (!ellipse) throw InputError("no ellipse fits the outline of the pad's letter: it is too thin");
  return *ellipse;
}

}  // namespace

LetterEllipse::LetterEllipse(const models::LandingPad& pad)
    : half_height_m_(pad.h_height_m / 2.0), in_pad_(FitLetter(pad)) {}

bool LetterEllipse::HasDirection() const {
  constexpr double kMinElongation = 1.1;
  return in_pad_.semi_axes.x() >= kMinElongation * in_pad_.semi_axes.y();
}

double LetterEllipse::StrokeAngle(const pad::Ellipse& image_ellipse) const {
  const bool major_axis_is_along_strokes = std::abs(std::cos(in_pad_.angle)) > std::abs(std::sin(in_pad_.angle));
  return major_axis_is_along_strokes ? image_ellipse.angle
                                     : models::WrapToHalfPi(image_ellipse.angle + models::kPi / 2.0);
}

std::optional<double> LetterEllipse::ProjectedStrokeAngle(const Eigen::Isometry3d& X_CW) const {
  if (!HasDirection()) {
    const Eigen::Vector3d from = X_CW * Eigen::Vector3d(-half_height_m_, 0.0, 0.0);
    const Eigen::Vector3d to = X_CW * Eigen::Vector3d(half_height_m_, 0.0, 0.0);
    const Eigen::Vector2d along = to.hnormalized() - from.hnormalized();
    return models::WrapToHalfPi(std::atan2(along.y(), along.x()));
  }
  Eigen::Matrix3d image_from_plane;
  image_from_plane << X_CW.linear().leftCols<2>(), X_CW.translation();
  const Eigen::Matrix3d plane_from_image = image_from_plane.inverse();
  const auto projected = pad::Ellipse::FromConic(plane_from_image.transpose() * in_pad_.Conic() * plane_from_image);
  if (!projected) return std::nullopt;
  return StrokeAngle(*projected);
}

}  // namespace touchdown::estimator::paper
