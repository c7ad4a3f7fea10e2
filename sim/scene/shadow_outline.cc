#include "sim/scene/shadow_outline.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "models/angles.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

constexpr int kCorners = 24;

/// Adds points on the ellipse with these half axes around `center`.
void AddEllipse(const Vector3d& center, const Vector3d& a, const Vector3d& b, std::vector<Vector3d>& points) {
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * models::kPi * i / kCorners;
    points.push_back(center + std::cos(angle) * a + std::sin(angle) * b);
  }
}

/// Adds the terminator of an ellipsoid in the light from `to_light`: the image of a great circle of the unit sphere.
void AddTerminator(const Vector3d& center, const Vector3d& half_axes, const Vector3d& to_light,
                   std::vector<Vector3d>& points) {
  const Vector3d pole = to_light.cwiseQuotient(half_axes).normalized();
  const Vector3d across = pole.unitOrthogonal();
  AddEllipse(center, half_axes.cwiseProduct(across), half_axes.cwiseProduct(pole.cross(across)), points);
}

/// Points in G. The convex hull of their shadows is the solid's shadow.
std::vector<Vector3d> Silhouette(mjtGeom type, const Vector3d& size_m, const Vector3d& to_light_G) {
  std::vector<Vector3d> points;
  switch (type) {
    case mjGEOM_BOX:
      for (int i = 0; i < 8; ++i) {
        points.push_back(size_m.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
      }
      break;
    case mjGEOM_CYLINDER:
      for (const double z : {-size_m.y(), size_m.y()}) {
        AddEllipse({0.0, 0.0, z}, size_m.x() * Vector3d::UnitX(), size_m.x() * Vector3d::UnitY(), points);
      }
      break;
    case mjGEOM_CAPSULE:
      for (const double z : {-size_m.y(), size_m.y()}) {
        AddTerminator({0.0, 0.0, z}, Vector3d::Constant(size_m.x()), to_light_G, points);
      }
      break;
    case mjGEOM_SPHERE:
      AddTerminator(Vector3d::Zero(), Vector3d::Constant(size_m.x()), to_light_G, points);
      break;
    case mjGEOM_ELLIPSOID:
      AddTerminator(Vector3d::Zero(), size_m, to_light_G, points);
      break;
    default:
      throw std::logic_error("the shadow of this geom type is not implemented");
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> ShadowOutline(const Solid& solid, const Vector3d& to_light) {
  std::vector<cv::Point2f> shadow, hull;
  for (const Vector3d& p_G : Silhouette(solid.type, solid.size_m, solid.X_WG.linear().transpose() * to_light)) {
    const Vector3d p_W = solid.X_WG * p_G;
    const Vector3d on_ground = p_W - p_W.z() / to_light.z() * to_light;
    shadow.emplace_back(static_cast<float>(on_ground.x()), static_cast<float>(on_ground.y()));
  }
  cv::convexHull(shadow, hull);
  std::vector<Eigen::Vector2d> outline;
  for (const cv::Point2f& p : hull) outline.emplace_back(p.x, p.y);
  return outline;
}

}  // namespace touchdown::sim
