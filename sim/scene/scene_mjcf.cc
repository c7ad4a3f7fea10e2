#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "models/angles.h"
#include "models/vehicle.h"
#include "sim/scene/geom_groups.h"
#include "sim/scene/scene.h"
#include "sim/scene/solid.h"
#include "sim/scene/textures.h"

namespace touchdown::sim {
namespace {

using Kind = SceneItem::Kind;

constexpr double kFloorDepth_m = 0.0010;
constexpr double kCenterDepth_m = 0.0008;
constexpr double kSheetDepth_m = 0.0005;
constexpr double kCoverHeight_m = 0.0005;
/// Number of rings in the mesh of a sphere and of a cylinder's wall. MuJoCo draws a cylinder with one ring without end
/// caps.
constexpr int kBallStacks = 10;

std::string Texture(const std::string& name, const TextureSize& size) {
  return fmt::format(
      "    <texture name='{0}' type='{1}' builtin='flat' rgb1='1 1 1' rgb2='1 1 1' width='{2}' height='{3}'/>\n"
      "    <material name='{0}' texture='{0}' texrepeat='1 1' specular='0' shininess='0' reflectance='0'/>\n",
      name, size.cube ? "cube" : "2d", size.width, size.height);
}

/// A visible sheet on the floor that does not collide. The third size of a plane, the spacing of its tessellation,
/// exceeds the sheet: one quad is enough under uniform light.
std::string Sheet(const std::string& name, const Eigen::Vector2d& center, double z, double yaw,
                  const Eigen::Vector2d& extent, const std::string& appearance) {
  return fmt::format(
      "    <geom name='{}' type='plane' pos='{} {} {}' euler='0 0 {}' size='{} {} 100' contype='0' conaffinity='0' "
      "{}/>\n",
      name, center.x(), center.y(), z, yaw, 0.5 * extent.x(), 0.5 * extent.y(), appearance);
}

const char* TypeName(mjtGeom type) {
  switch (type) {
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_CYLINDER:
      return "cylinder";
    default:
      return "ellipsoid";
  }
}

std::string SolidGeom(const std::string& name, const SceneItem& item) {
  const sim::Solid solid = SolidOf(item);
  return fmt::format(
      "    <geom name='{0}' type='{1}' pos='{2} {3} {4}' euler='0 0 {5}' size='{6} {7} {8}' material='{0}'/>\n", name,
      TypeName(solid.type), item.position_m.x(), item.position_m.y(), solid.X_WG.translation().z(), item.yaw,
      solid.size_m.x(), solid.size_m.y(), solid.size_m.z());
}

/// A plain material that emits light.
std::string EmissiveMaterial(const std::string& name, const std::string& rgba, double emission) {
  return fmt::format("    <material name='{}' rgba='{}' emission='{}' specular='0' shininess='0' reflectance='0'/>\n",
                     name, rgba, emission);
}

std::string Assets(const Scene& scene) {
  std::string assets =
      Texture("floor", FloorTexture(scene.config)) + Texture("floor_center", FloorCenterTexture(scene.config));
  if (scene.config.IsOutdoor())
    assets += EmissiveMaterial("sky", "0.62 0.78 1 1", 1.0) + EmissiveMaterial("hedge", "0.16 0.28 0.11 1", 0.6);
  if (scene.config.pad) assets += Texture("pad", PadTextureSize(scene.pad));
  for (std::size_t i = 0; i < scene.items.size(); ++i) assets += Texture(ItemName(i), SizeFor(scene.items[i]));
  return assets;
}

/// Four walls around the scene, at `distance_m` from its center and `height_m` high.
std::string Walls(double distance_m, double height_m, const std::string& appearance) {
  std::string walls;
  for (const auto& [x, y] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
    const double half_width = x != 0 ? 0.5 * height_m : distance_m, half_height = x != 0 ? distance_m : 0.5 * height_m;
    walls += fmt::format(
        "    <geom type='plane' pos='{} {} {}' zaxis='{} {} 0' size='{} {} 100' contype='0' conaffinity='0' "
        "group='{}' {}/>\n",
        x * distance_m, y * distance_m, 0.5 * height_m, -x, -y, half_width, half_height, int{kSurroundings},
        appearance);
  }
  return walls;
}

/// Walls of a room, or a hedge in front of a bright sky. They are plain because they are in view at steep tilts only.
std::string Surroundings(const Scene& scene) {
  constexpr double kWallReflectance = 0.6, kHedgeHeight_m = 1.2, kHedgeDepth_m = 0.1;
  const double far = 0.5 * scene.config.floor_size_m;
  if (!scene.config.IsOutdoor()) {
    const double gray = std::min(1.0, kWallReflectance * scene.config.illumination);
    return Walls(far, scene.config.floor_size_m, fmt::format("rgba='{0} {0} {0} 1'", gray));
  }
  return Walls(far - kHedgeDepth_m, kHedgeHeight_m, "material='hedge'") +
         Walls(far, scene.config.floor_size_m, "material='sky'");
}

/// Light of the scene. It adds up to 1 on upward-facing surfaces, so that the floor appears with the levels of its
/// textures. Indoors this is 0.45 ambient light plus 0.5932 from a direction whose cosine with the vertical is 0.9275.
std::string Light(const SceneConfig& config) {
  if (!config.IsOutdoor()) {
    return "    <light name='room' directional='true' castshadow='false' dir='0.35 0.2 -1' ambient='0.45 0.45 0.45' "
           "diffuse='0.5932 0.5932 0.5932' specular='0 0 0'/>\n";
  }
  const Eigen::Vector3d to_sun = config.sun.Direction();
  const double sky = config.sun.Shade(), sun = (1.0 - sky) / to_sun.z();
  return fmt::format(
      "    <light name='{0}' directional='true' castshadow='false' dir='{1} {2} {3}' ambient='{4} {4} {4}' "
      "diffuse='{5} {5} {5}' specular='0 0 0'/>\n",
      kSunName, -to_sun.x(), -to_sun.y(), -to_sun.z(), sky, sun);
}

/// Geoms of the scene from top to bottom, an order in which hidden pixels are not shaded.
std::string SceneGeoms(const Scene& scene) {
  std::string geoms;
  const Eigen::Vector2d sheet(scene.pad.sheet_length_m, scene.pad.sheet_width_m);
  const double white = PaperLevel(scene) / 255.0;
  geoms += Sheet(kPadCoverName, Eigen::Vector2d::Zero(), kCoverHeight_m, 0.0, sheet + Eigen::Vector2d::Constant(0.02),
                 fmt::format("rgba='{0} {0} {0} 0'", white));
  if (scene.config.pad) geoms += Sheet("pad", Eigen::Vector2d::Zero(), 0.0, 0.0, sheet, "material='pad'");
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const SceneItem& item = scene.items[i];
    const std::string name = ItemName(i);
    geoms += item.IsFlat() ? Sheet(name, item.position_m, -kSheetDepth_m, item.yaw, item.size_m.head<2>(),
                                   fmt::format("material='{}'", name))
                           : SolidGeom(name, item);
  }
  geoms += Sheet("floor_center", Eigen::Vector2d::Zero(), -kCenterDepth_m, 0.0,
                 Eigen::Vector2d::Constant(kFloorCenterSize_m), "material='floor_center'");
  geoms += Sheet("floor_print", Eigen::Vector2d::Zero(), -kFloorDepth_m, 0.0,
                 Eigen::Vector2d::Constant(scene.config.floor_size_m),
                 fmt::format("material='floor' group='{}'", int{kSurroundings}));
  return geoms + Surroundings(scene);
}

}  // namespace

/// RK4 keeps free fall and torque-free rotation exact to round-off; elliptic cones keep a resting vehicle in place.
std::string SceneMjcf(const Scene& scene, const std::string& vehicle_body, double timestep_s) {
  return fmt::format(
      "<mujoco model='touchdown'>\n"
      "  <compiler angle='radian' coordinate='local'/>\n"
      "  <option timestep='{timestep}' gravity='0 0 -{gravity}' integrator='RK4' cone='elliptic' "
      "impratio='10'/>\n"
      "  <size njmax='600' nconmax='200'/>\n"
      "  <statistic center='0 0 0.5' extent='2'/>\n"
      "  <visual>\n"
      "    <headlight ambient='0 0 0' diffuse='0 0 0' specular='0 0 0'/>\n"
      "    <quality shadowsize='0' offsamples='0' numslices='24' numstacks='{stacks}' numquads='1'/>\n"
      "  </visual>\n"
      "  <asset>\n{assets}  </asset>\n"
      "  <worldbody>\n"
      "{light}"
      "    <geom name='floor' type='plane' size='{floor} {floor} 100' group='{invisible}' rgba='0 0 0 0'/>\n"
      "{geoms}{vehicle}\n"
      "  </worldbody>\n"
      "</mujoco>\n",
      fmt::arg("timestep", timestep_s), fmt::arg("gravity", models::kGravity_m_s2), fmt::arg("assets", Assets(scene)),
      fmt::arg("light", Light(scene.config)), fmt::arg("stacks", scene.config.IsOutdoor() ? kBallStacks : 1),
      fmt::arg("floor", 0.5 * scene.config.floor_size_m), fmt::arg("invisible", int{kInvisible}),
      fmt::arg("geoms", SceneGeoms(scene)), fmt::arg("vehicle", vehicle_body));
}

}  // namespace touchdown::sim
