#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "models/landing_pad.h"

struct mjModel_;

namespace touchdown::sim {

/// What lies around the pad. The layout is drawn from the flight's seed (stream "scene").
struct SceneConfig {
  double floor_size_m = 10.0;
  int posters = 14;       ///< Sheets rich in texture.
  int lone_circles = 6;   ///< Rings without an H inside.
  int lone_letters = 6;   ///< Letters H without a ring.
  int objects = 8;        ///< Solid boxes and cylinders.
  double illumination = 1.0;  ///< Gain of the room's light, 1: nominal.
  bool pad = true;        ///< Whether the landing pad is there at all.

  void Validate() const;
};

/// A flat, printed thing on the floor, or a solid one, at its pose on the floor.
struct SceneItem {
  enum class Kind { kPoster, kRing, kLetterH, kBox, kCylinder };
  Kind kind = Kind::kPoster;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Centre, in W.
  double yaw = 0.0;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< Full extents along the item's own axes; z is 0 when flat.
  std::uint64_t texture_seed = 0;
};

struct Scene {
  SceneConfig config;
  models::LandingPad pad;
  std::vector<SceneItem> items;
  std::uint64_t floor_seed = 0;
};

/// Draws a layout. Nothing lies over the pad's sheet; solid objects keep clear of the flight path above it.
Scene MakeScene(const SceneConfig& config, const models::LandingPad& pad, std::uint64_t seed);

/// The whole MJCF: options, assets, floor, pad, items, lights, and `vehicle_body` (a <body> element) among them.
std::string SceneMjcf(const Scene& scene, const std::string& vehicle_body, double timestep_s);

/// Fills the pixels of the textures that SceneMjcf declares, before a GL context is made of the model.
void PaintTextures(const Scene& scene, mjModel_& model);

}  // namespace touchdown::sim
