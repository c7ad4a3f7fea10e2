#pragma once

#include <optional>
#include <vector>

#include "sim/render/floor_footprint.h"

struct mjModel_;
struct mjrContext_;

namespace touchdown::sim {

/// Mip level whose texels are nearest to a pixel in length, for a texture at `depth_m` that faces the camera.
int MipLevel(double texels_per_m, double depth_m, double focal_px);

/// Selects texture filters. A view with a nearly constant depth of the floor uses one mip level of a sheet's texture
/// for a whole frame, which is a third faster than a choice per pixel. Other views choose the level per pixel. The
/// levels of the pad's texture are blended, so that its sharpness does not jump with height, except in the closest
/// views, in which the pad fills the image and vision is blind.
class TextureFilter {
 public:
  /// Filters the textures of `model` in `context`. The GL context in which they were created must be current in all
  /// member calls.
  TextureFilter(const mjModel_& model, const mjrContext_& context);

  /// Adapts the filters to a camera with this footprint and focal length. Call it before each frame.
  void AdaptTo(const std::optional<FloorFootprint>& footprint, double focal_px);

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
