#include "sim/scene/shadow_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/random_stream.h"
#include "sim/scene/sun.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Sun kSun{.elevation_deg = 40.0, .azimuth_deg = 115.0};

bool Inside(const std::vector<Vector2d>& outline, const Vector2d& p) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d edge = outline[(i + 1) % outline.size()] - outline[i], to_p = p - outline[i];
    (edge.x() * to_p.y() - edge.y() * to_p.x() > 0.0 ? left : right) += 1;
  }
  return left == 0 || right == 0;
}

/// Whether a ray from p_W towards the light meets the solid, by marching along the ray.
bool IsBlocked(const Solid& solid, const Vector3d& p_W, const Vector3d& to_light) {
  const Vector3d half = solid.size_m;
  for (double t = 0.0; t < 3.0; t += 0.001) {
    const Vector3d q = solid.X_WG.inverse() * Vector3d(p_W + t * to_light);
    const double radius = q.head<2>().norm();
    switch (solid.type) {
      case mjGEOM_BOX:
        if ((q.cwiseAbs() - half).maxCoeff() < 0.0) return true;
        break;
      case mjGEOM_CYLINDER:
        if (radius < half.x() && std::abs(q.z()) < half.y()) return true;
        break;
      case mjGEOM_CAPSULE:
        if ((q - Vector3d(0.0, 0.0, std::clamp(q.z(), -half.y(), half.y()))).norm() < half.x()) return true;
        break;
      case mjGEOM_SPHERE:
        if (q.norm() < half.x()) return true;
        break;
      default:
        if (q.cwiseQuotient(half).norm() < 1.0) return true;
    }
  }
  return false;
}

TEST(ShadowOutline, ContainsThePointsFromWhichTheLightIsBlocked) {
  models::RandomStream random(1, "test");
  for (const mjtGeom type : {mjGEOM_BOX, mjGEOM_CYLINDER, mjGEOM_CAPSULE, mjGEOM_SPHERE, mjGEOM_ELLIPSOID}) {
    Solid solid{.type = type, .size_m = {0.12, 0.2, 0.08}};
    solid.X_WG.linear() = models::RotationFromTaitBryan({.roll = 0.4, .pitch = -0.7, .yaw = 1.1});
    solid.X_WG.translation() = Vector3d(0.3, -0.1, 0.6);
    const auto outline = ShadowOutline(solid, kSun.Direction());
    Vector2d low = outline.front(), high = low;
    for (const Vector2d& corner : outline) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    int agree = 0, shaded = 0;
    constexpr int kPoints = 400;
    for (int i = 0; i < kPoints; ++i) {
      const Vector2d p(random.Uniform(low.x() - 0.05, high.x() + 0.05),
                       random.Uniform(low.y() - 0.05, high.y() + 0.05));
      const bool blocked = IsBlocked(solid, {p.x(), p.y(), 0.0}, kSun.Direction());
      shaded += blocked ? 1 : 0;
      agree += blocked == Inside(outline, p) ? 1 : 0;
    }
    EXPECT_GT(shaded, kPoints / 4);
    EXPECT_GE(agree, kPoints - 8) << "a polygon of 24 corners covers 99 % of a circle; type " << type;
  }
}

TEST(ShadowOutline, HasTheLengthOfAPolesShadowForTheSunsElevation) {
  Solid pole{.type = mjGEOM_CYLINDER, .size_m = {0.001, 0.5, 0.0}};
  pole.X_WG.translation().z() = 0.5;
  const double length = 1.0 / std::tan(models::DegToRad(kSun.elevation_deg));
  Vector2d tip = Vector2d::Zero();
  for (const Vector2d& corner : ShadowOutline(pole, kSun.Direction())) {
    if (corner.norm() > tip.norm()) tip = corner;
  }
  const double away = models::DegToRad(kSun.azimuth_deg + 180.0);
  EXPECT_LT((tip - length * Vector2d(std::cos(away), std::sin(away))).norm(), 0.003);
}

}  // namespace
}  // namespace touchdown::sim
