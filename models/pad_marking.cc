#include "models/pad_marking.h"

#include <Eigen/Geometry>
#include <cmath>

#include "models/angles.h"

namespace touchdown::models {
namespace {

/// Distance from W's origin to the marking's farthest point, m.
double Reach(const PadMarking& marking) {
  if (marking.shape == PadMarking::Shape::kDisc) return marking.center_m.norm() + 0.5 * marking.diameter_m;
  const Eigen::Vector2d along_bar = Eigen::Rotation2Dd(-DegToRad(marking.angle_deg)) * marking.center_m;
  return (along_bar.cwiseAbs() + 0.5 * Eigen::Vector2d(marking.length_m, marking.width_m)).norm();
}

}  // namespace

void PadMarking::Validate(double radius_m) const {
  ValidateConfig(*this);
  if (Reach(*this) >= radius_m) {
    throw InputError("a marking of the pad must be entirely within its ring, with a white gap");
  }
}

void Describe(ConfigVisitor& v, PadMarking& m) {
  v.Choice({"shape", "Shape of the marking: a disc, or a bar (a rectangle).", true}, m.shape, PadMarking::kShapeNames);
  v.Number({"x_m", "X of the marking's center in W.", true}, m.center_m.x(), kMeter, kAny);
  v.Number({"y_m", "Y of the marking's center in W.", true}, m.center_m.y(), kMeter, kAny);
  switch (m.shape) {
    case PadMarking::Shape::kDisc:
      v.Number({"diameter_m", "Diameter of the disc (disc only).", true}, m.diameter_m, kMeter, kPositive);
      break;
    case PadMarking::Shape::kBar:
      v.Number({"length_m", "Length of the bar, along angle_deg (bar only).", true}, m.length_m, kMeter, kPositive);
      v.Number({"width_m", "Width of the bar, across its length (bar only).", true}, m.width_m, kMeter, kPositive);
      v.Number({"angle_deg", "Direction of the bar's length, from W's X towards Y (bar only)."}, m.angle_deg, kDegree,
               Between(-180.0, 180.0));
      break;
  }
}

}  // namespace touchdown::models
