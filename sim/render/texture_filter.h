#pragma once

#include <optional>
#include <vector>

#include "sim/render/floor_footprint.h"

struct mjModel_;
struct mjrContext_;

namespace touchdown::sim {

/// The mip level whose texels are nearest to a pixel in length, for a texture `depth_m` away that faces the camera.
int MipLevel(double texels_per_m, double depth_m, double focal_px);

/// Texture filtering. A view with a nearly constant depth of the floor uses one mip level of a sheet's texture for the
/// whole frame, which takes a third less time than a choice per pixel. Other views choose it per pixel. The levels of
/// the pad are blended, so that its sharpness does not jump with height, except in the closest views, which it fills
/// and where vision is blind.
class TextureFilter {
 public:
  /// For the textures of `model` in `context`. The GL context in which they were created must be current in all
  /// members.
  TextureFilter(const mjModel_& model, const mjrContext_& context);

  /// Call before a frame of a camera with focal length `focal_px` and this footprint.
  void SuitTo(const std::optional<FloorFootprint>& footprint, double focal_px);

 private:
  struct Sheet {
    unsigned texture = 0;
    double texels_per_m = 0.0;
    bool is_pad = false;
    std::optional<int> level = std::nullopt;  ///< Current level; nullopt when chosen per pixel.
  };

  std::vector<Sheet> sheets_;
};

}  // namespace touchdown::sim
