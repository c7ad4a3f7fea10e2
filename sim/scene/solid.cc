#include "sim/scene/solid.h"

#include <stdexcept>

namespace touchdown::sim {

Solid SolidOf(const SceneItem& item) {
  const Eigen::Vector3d half = 0.5 * item.size_m;
  Solid solid;
  solid.X_WG.translation() << item.position_m, half.z();
  solid.X_WG.linear() = Eigen::AngleAxisd(item.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  switch (item.kind) {
    case SceneItem::Kind::kBox:
      solid.type = mjGEOM_BOX;
      solid.size_m = half;
      return solid;
    case SceneItem::Kind::kCylinder:
      solid.type = mjGEOM_CYLINDER;
      solid.size_m << half.x(), half.z(), 0.0;
      return solid;
    case SceneItem::Kind::kBall:
    case SceneItem::Kind::kStone:
      solid.type = mjGEOM_ELLIPSOID;
      solid.size_m = half;
      return solid;
    default:
      throw std::logic_error("a flat item has no solid");
  }
}

}  // namespace touchdown::sim
