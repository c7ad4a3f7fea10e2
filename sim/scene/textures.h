#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>

#include "sim/scene/scene.h"

namespace touchdown::sim {

/// Size of a texture as its MJCF declares it, in texels. The size of a cube texture is that of one face.
struct TextureSize {
  bool cube = false;
  int width = 0;
  int height = 0;
};

TextureSize FloorTexture(const SceneConfig& config);
TextureSize FloorCenterTexture(const SceneConfig& config);
/// Side of the square around the pad that has a finer floor texture.
inline constexpr double kFloorCenterSize_m = 3.0;

/// Size of an item's texture.
TextureSize SizeFor(const SceneItem& item);

/// Size of the pad's texture. Texels are square, because OpenGL chooses the mip level by a texel's longer side: oblong
/// texels would blur more along that side and, near hover, rotate the axes of the ring's ellipse by more than noise
/// does. A texel is at most 0.2 mm long (longer on a sheet over 0.8 m long). Both sizes are multiples of 64, so that
/// they can be halved six times.
TextureSize PadTextureSize(const models::LandingPad& pad);

/// Common name of an item's geom, material and texture.
std::string ItemName(std::size_t index);

/// Gray level, 0 to 255, of the pad's paper at the pad's center, at the scene's illumination.
double PaperLevel(const Scene& scene);

/// Relative brightness of the room's light over the floor: 1 at the pad's center, smooth, within [0.75, 1.12]
/// everywhere. It is drawn from the scene's seed and painted into all flat items.
class RoomLight {
 public:
  explicit RoomLight(const Scene& scene);
  double At(const Eigen::Vector2d& p_W) const;

 private:
  struct Pool {
    Eigen::Vector2d center_m;
    double radius_m;
    double gain;
  };
  double Raw(const Eigen::Vector2d& p_W) const;

  std::array<Pool, 3> pools_;
  Eigen::Vector2d slope_;
};

}  // namespace touchdown::sim
