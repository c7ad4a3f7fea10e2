#pragma once

#include <optional>
#include <vector>

#include "sim/render/floor_footprint.h"

struct mjModel_;
struct mjrContext_;

namespace touchdown::sim {

/// The mip level whose texels are nearest to a pixel in length, for a texture `depth_m` away that faces the camera.
int MipLevel(double texels_per_m, double depth_m, double focal_px);

/// How textures are filtered. A view that shows the floor about equally far away everywhere takes one mip level of a
/// sheet's texture for the whole frame, which spares a third of the time that choosing one for every pixel takes. Other
/// views have theirs chosen by pixel. The pad's levels are blended, so that its sharpness does not jump with height,
/// but in the closest views, which it fills and where vision is blind.
class TextureFilter {
 public:
  /// For the textures of `model` in `context`. The GL context that they were made in is current here and below.
  TextureFilter(const mjModel_& model, const mjrContext_& context);

  /// Before a frame of a camera of focal length `focal_px` that sees this of the floor.
  void SuitTo(const std::optional<FloorFootprint>& footprint, double focal_px);

 private:
  struct Sheet {
    unsigned texture = 0;
    double texels_per_m = 0.0;
    bool is_pad = false;
    std::optional<int> level = std::nullopt;  ///< What it is drawn at now; none when chosen by pixel.
  };

  std::vector<Sheet> sheets_;
};

}  // namespace touchdown::sim
