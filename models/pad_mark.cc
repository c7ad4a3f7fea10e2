#include "models/pad_mark.h"

#include <Eigen/Geometry>
#include <cmath>

#include "models/angles.h"

namespace touchdown::models {
namespace {

/// From W's origin to the mark's farthest point.
double Reach(const PadMark& mark) {
  if (mark.shape == PadMark::Shape::kDisc) return mark.center_m.norm() + 0.5 * mark.diameter_m;
  const Eigen::Vector2d along_bar = Eigen::Rotation2Dd(-DegToRad(mark.angle_deg)) * mark.center_m;
  return (along_bar.cwiseAbs() + 0.5 * Eigen::Vector2d(mark.length_m, mark.width_m)).norm();
}

}  // namespace

void PadMark::Validate(double radius_m) const {
  ValidateConfig(*this);
  if (Reach(*this) >= radius_m) throw InputError("a pad's mark must lie wholly within its ring, with a white gap");
}

void Describe(ConfigVisitor& v, PadMark& m) {
  v.Choice({"shape", "Shape of the marking: a disc, or a bar (a rectangle).", true}, m.shape, PadMark::kShapeNames);
  v.Number({"x_m", "X of the marking's center in W.", true}, m.center_m.x(), kMeter, kAny);
  v.Number({"y_m", "Y of the marking's center in W.", true}, m.center_m.y(), kMeter, kAny);
  switch (m.shape) {
    case PadMark::Shape::kDisc:
      v.Number({"diameter_m", "Diameter of the disc (disc only).", true}, m.diameter_m, kMeter, kPositive);
      break;
    case PadMark::Shape::kBar:
      v.Number({"length_m", "Length of the bar, along angle_deg (bar only).", true}, m.length_m, kMeter, kPositive);
      v.Number({"width_m", "Width of the bar, across its length (bar only).", true}, m.width_m, kMeter, kPositive);
      v.Number({"angle_deg", "Direction of the bar's length, from W's X towards Y (bar only)."}, m.angle_deg, kDegree,
               Between(-180.0, 180.0));
      break;
  }
}

}  // namespace touchdown::models
