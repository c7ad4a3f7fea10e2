#include "models/pad_outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "models/angles.h"

namespace touchdown::models {
namespace {

using Eigen::Vector2d;
using Color = PadShape::Color;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Vector2d& CornerAfter(const Polygon& polygon, std::size_t i) {
  return polygon.corners_m[(i + 1) % polygon.corners_m.size()];
}

bool IsOnSegment(const Vector2d& from, const Vector2d& to, const Vector2d& p) {
  const Vector2d along = to - from, from_start = p - from;
  const bool in_box = (p - from.cwiseMin(to)).minCoeff() >= 0.0 && (from.cwiseMax(to) - p).minCoeff() >= 0.0;
  return in_box && along.x() * from_start.y() == along.y() * from_start.x();
}

double DistanceFromSegment(const Vector2d& from, const Vector2d& to, const Vector2d& p) {
  const Vector2d along = to - from;
  const double fraction = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from + fraction * along - p).norm();
}

bool Contains(const Circle& circle, const Vector2d& p, bool on_outline) {
  const double distance = (p - circle.center_m).norm();
  return on_outline ? distance <= circle.radius_m : distance < circle.radius_m;
}

bool Contains(const Polygon& polygon, const Vector2d& p, bool on_outline) {
  bool inside = false;
  Vector2d from = polygon.corners_m.back();
  for (const Vector2d& to : polygon.corners_m) {
    const bool is_beside = std::min(from.y(), to.y()) <= p.y() && p.y() <= std::max(from.y(), to.y());
    if (is_beside && IsOnSegment(from, to, p)) return on_outline;
    if ((from.y() > p.y()) != (to.y() > p.y())) {
      const double fraction = (p.y() - from.y()) / (to.y() - from.y());
      if (p.x() < from.x() + fraction * (to.x() - from.x())) inside = !inside;
    }
    from = to;
  }
  return inside;
}

/// Distance between two segments that do not cross, m.
double Gap(const Vector2d& from_a, const Vector2d& to_a, const Vector2d& from_b, const Vector2d& to_b) {
  return std::min({DistanceFromSegment(from_a, to_a, from_b), DistanceFromSegment(from_a, to_a, to_b),
                   DistanceFromSegment(from_b, to_b, from_a), DistanceFromSegment(from_b, to_b, to_a)});
}

double Gap(const Circle& a, const Circle& b) {
  const double distance = (a.center_m - b.center_m).norm();
  return std::max(distance - a.radius_m - b.radius_m, std::abs(a.radius_m - b.radius_m) - distance);
}

double Gap(const Circle& circle, const Polygon& polygon) {
  double gap = kInfinity;
  for (std::size_t i = 0; i < polygon.corners_m.size(); ++i) {
    const Vector2d from = polygon.corners_m[i], to = CornerAfter(polygon, i);
    const double nearest = DistanceFromSegment(from, to, circle.center_m);
    const double farthest = std::max((from - circle.center_m).norm(), (to - circle.center_m).norm());
    gap = std::min(gap, std::max(nearest - circle.radius_m, circle.radius_m - farthest));
  }
  return gap;
}

double Gap(const Polygon& polygon, const Circle& circle) { return Gap(circle, polygon); }

double Gap(const Polygon& a, const Polygon& b) {
  double gap = kInfinity;
  for (std::size_t i = 0; i < a.corners_m.size(); ++i) {
    for (std::size_t j = 0; j < b.corners_m.size(); ++j) {
      gap = std::min(gap, Gap(a.corners_m[i], CornerAfter(a, i), b.corners_m[j], CornerAfter(b, j)));
    }
  }
  return gap;
}

double NarrowestPart(const Circle& circle) { return 2.0 * circle.radius_m; }

/// Rectangle around `center`, rotated by `angle`, rad, from X towards Y.
Polygon Rectangle(const Vector2d& size, const Vector2d& center = Vector2d::Zero(), double angle = 0.0) {
  const Eigen::Rotation2Dd rotation(angle);
  Polygon rectangle;
  for (const Vector2d& corner : {Vector2d(1, 1), Vector2d(-1, 1), Vector2d(-1, -1), Vector2d(1, -1)}) {
    rectangle.corners_m.push_back(center + rotation * (0.5 * corner.cwiseProduct(size)));
  }
  return rectangle;
}

std::vector<Vector2d> LetterQuarter(const LandingPad& pad) {
  const double x = 0.5 * pad.h_height_m, y = 0.5 * pad.h_width_m;
  if (pad.letter() == PadLetter::kRectangle) return {{x, y}};
  const double bar_x = 0.5 * pad.h_stroke_m, inner_y = y - pad.h_stroke_m;
  return {{bar_x, inner_y}, {x, inner_y}, {x, y}};
}

/// The polygon that is symmetric about both axes and has these corners in the first quadrant, counter-clockwise.
Polygon Mirrored(const std::vector<Vector2d>& quarter) {
  Polygon polygon;
  for (const Vector2d& mirror : {Vector2d(1, 1), Vector2d(-1, 1), Vector2d(-1, -1), Vector2d(1, -1)}) {
    std::vector<Vector2d> corners;
    for (const Vector2d& corner : quarter) corners.push_back(corner.cwiseProduct(mirror));
    if (mirror.prod() < 0.0) std::reverse(corners.begin(), corners.end());
    polygon.corners_m.insert(polygon.corners_m.end(), corners.begin(), corners.end());
  }
  return polygon;
}

PadShape ShapeOf(const PadMarking& marking) {
  if (marking.shape == PadMarking::Shape::kDisc) {
    return {Color::kBlack, Circle{marking.center_m, 0.5 * marking.diameter_m}};
  }
  return {Color::kBlack, Rectangle({marking.length_m, marking.width_m}, marking.center_m, DegToRad(marking.angle_deg))};
}

/// The smallest width of one of the shapes or gap between two of them.
double Narrowest(std::span<const PadShape> shapes) {
  double narrowest = kInfinity;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double part = std::visit([](const auto& outline) { return NarrowestPart(outline); }, shapes[i].outline);
    narrowest = std::min(narrowest, part);
    for (std::size_t j = 0; j < i; ++j) {
      const double gap =
          std::visit([](const auto& a, const auto& b) { return Gap(a, b); }, shapes[i].outline, shapes[j].outline);
      narrowest = std::min(narrowest, gap);
    }
  }
  return narrowest;
}

}  // namespace

bool PadShape::Contains(const Vector2d& p_W) const {
  return std::visit([&](const auto& shape) { return models::Contains(shape, p_W, color == Color::kBlack); }, outline);
}

PadOutline::PadOutline(const LandingPad& pad) : letter_quarter_(LetterQuarter(pad)) {
  shapes_ = {{Color::kWhite, Rectangle({pad.sheet_length_m, pad.sheet_width_m})},
             {Color::kBlack, Circle{.radius_m = pad.outer_radius_m}},
             {Color::kWhite, Circle{.radius_m = pad.inner_radius_m()}},
             {Color::kBlack, Mirrored(letter_quarter_)}};
  narrowest_m_ = Narrowest(shapes_);
  for (const PadMarking& marking : pad.marks) shapes_.push_back(ShapeOf(marking));

  const Polygon& outline = letter();
  for (std::size_t i = 0; i < outline.corners_m.size(); ++i) {
    const Vector2d from = outline.corners_m[i], along = CornerAfter(outline, i) - from;
    letter_sides_.push_back({from, along, 1.0 / along.squaredNorm()});
  }
}

bool PadOutline::IsBlack(const Vector2d& p_W) const {
  const auto top =
      std::find_if(shapes_.rbegin(), shapes_.rend(), [&](const auto& shape) { return shape.Contains(p_W); });
  return top != shapes_.rend() && top->color == Color::kBlack;
}

double PadOutline::DistanceFromLetter(const Vector2d& p_W) const {
  double nearest = kInfinity;
  for (const Side& side : letter_sides_) {
    const Vector2d from_start = p_W - side.from_m;
    const double fraction = std::clamp(from_start.dot(side.along_m) * side.per_squared_length, 0.0, 1.0);
    nearest = std::min(nearest, (from_start - fraction * side.along_m).squaredNorm());
  }
  return std::sqrt(nearest);
}

std::vector<Vector2d> PadOutline::PointsAlongLetter(double spacing_m) const {
  std::vector<Vector2d> path{{0.0, letter_quarter_.back().y()}};  // From the Y axis to the X axis.
  path.insert(path.end(), letter_quarter_.rbegin(), letter_quarter_.rend());
  path.push_back({letter_quarter_.front().x(), 0.0});
  std::vector<Vector2d> points;
  for (const Vector2d& mirror : {Vector2d(1, 1), Vector2d(1, -1), Vector2d(-1, -1), Vector2d(-1, 1)}) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Vector2d from = path[i], side = path[i + 1] - from;
      const int count = std::max(2, static_cast<int>(side.norm() / spacing_m));
      for (int k = 0; k < count; ++k) points.push_back((from + side * ((k + 0.5) / count)).cwiseProduct(mirror));
    }
  }
  return points;
}

double NarrowestPart(const Polygon& polygon) {
  const auto& corners = polygon.corners_m;
  double narrowest = kInfinity;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 2; j < corners.size(); ++j) {
      if (i == 0 && j + 1 == corners.size()) continue;
      narrowest = std::min(narrowest, Gap(corners[i], corners[i + 1], corners[j], CornerAfter(polygon, j)));
    }
  }
  return narrowest;
}

}  // namespace touchdown::models
