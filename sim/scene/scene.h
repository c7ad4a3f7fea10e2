#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "models/describe.h"
#include "models/landing_pad.h"
#include "sim/scene/sun.h"

struct mjModel_;

namespace touchdown::sim {

/// Surroundings of the pad. The layout is drawn from the seed of the flight (stream "scene").
struct SceneConfig {
  enum class Setting {
    kIndoor,   ///< A floor between four walls, with nearly even light.
    kOutdoor,  ///< Grass and a path past the pad, in the sun.
  };
  static constexpr std::array<std::string_view, 2> kSettingNames = {"indoor", "outdoor"};

  Setting setting = Setting::kIndoor;
  double floor_size_m = 10.0;
  int posters = 14;
  int lone_circles = 6;
  int lone_letters = 6;
  int objects = 8;
  double illumination = 1.0;
  bool pad = true;
  Sun sun = {};

  bool IsOutdoor() const { return setting == Setting::kOutdoor; }

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or for more than 80 items.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, SceneConfig& config);

/// A flat printed item or a solid item, with its pose on the floor.
struct SceneItem {
  enum class Kind { kPoster, kRing, kLetterH, kRectangle, kBox, kCylinder, kBall, kStone };
  Kind kind = Kind::kPoster;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Center, in W.
  double yaw = 0.0;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< Full extents along the item's own axes; z is 0 when flat.
  std::uint64_t texture_seed = 0;

  bool IsFlat() const { return kind < Kind::kBox; }
  /// Corners of its rectangle on the floor in W, counter-clockwise.
  std::array<Eigen::Vector2d, 4> Corners() const;
};

/// Whether two rectangles on the floor are closer than `gap_m` to each other (separating axis theorem; at corners the
/// gap is measured along the axes of the rectangles).
bool Overlap(const SceneItem& a, const SceneItem& b, double gap_m);

struct Scene {
  SceneConfig config;
  models::LandingPad pad;
  std::vector<SceneItem> items;
  std::uint64_t floor_seed = 0;
};

/// Smallest allowed distance between the pad's center and any part of a solid item, m. It keeps the flight path clear.
inline constexpr double kSolidKeepOut_m = 0.60;

/// Draws a random layout. No item overlaps the pad's sheet or another item, solid items keep the flight path clear, and
/// most flat items are within 1.5 m of the pad, in view of the camera. Throws InputError when the floor is too small
/// for the items.
Scene MakeScene(const SceneConfig& config, const models::LandingPad& pad, std::uint64_t seed);

inline constexpr char kPadCoverName[] = "pad_cover";
/// Name of the light of an outdoor scene. Its ambient part is the light of the sky.
inline constexpr char kSunName[] = "sun";

/// Complete MJCF document: options, assets, floor, pad, items, lights and `vehicle_body` (a `<body>` element).
///
/// The pad's sheet is at z = 0, the other sheets are 0.5 mm and the visible floor up to 1 mm below it; the solid floor
/// "floor" is an invisible plane at z = 0. GeomGroup defines the visibility. The sheet kPadCoverName above the pad is
/// transparent until its alpha is set to 1.
std::string SceneMjcf(const Scene& scene, const std::string& vehicle_body, double timestep_s);

/// Fills the textures that SceneMjcf declares. Call it before a GL context is made for the model.
void PaintTextures(const Scene& scene, mjModel_& model);

}  // namespace touchdown::sim
