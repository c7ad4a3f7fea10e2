#include "sim/render/texture_filter.h"

#include <GL/gl.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace touchdown::sim {
namespace {

/// Largest ratio of the depths that share one mip level, the ratio of two neighboring levels.
constexpr double kMaxDepthRatio = 2.0;
constexpr int kAllLevels = 1000;
/// Mip level of the pad from less than 0.2 m, where the pad fills the view.
constexpr int kLevelOfFullView = 1;

GLint FilterByPixel(bool is_pad) { return is_pad ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST; }

void SetParameters(GLenum target, GLuint texture, std::initializer_list<std::pair<GLenum, GLint>> parameters) {
  glBindTexture(target, texture);
  for (const auto& [name, value] : parameters) glTexParameteri(target, name, value);
  glBindTexture(target, 0);
}

}  // namespace

int MipLevel(double texels_per_m, double depth_m, double focal_px) {
  return static_cast<int>(std::max(0.0, std::round(std::log2(texels_per_m * depth_m / focal_px))));
}

TextureFilter::TextureFilter(const mjModel& model, const mjrContext& context) {
  const int pad = mj_name2id(&model, mjOBJ_TEXTURE, "pad");
  for (int i = 0; i < context.ntexture; ++i) {
    const GLenum target = context.textureType[i] == mjTEXTURE_2D ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP;
    SetParameters(target, context.texture[i], {{GL_TEXTURE_MIN_FILTER, FilterByPixel(i == pad)}});
  }
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int material = model.geom_matid[geom];
    if (model.geom_type[geom] != mjGEOM_PLANE || material < 0) continue;
    const int texture = model.mat_texid[material];
    if (texture < 0) continue;
    const mjtNum* half_size_m = model.geom_size + 3 * geom;
    sheets_.push_back({.texture = context.texture[texture],
                       .texels_per_m = std::max(0.5 * model.tex_width[texture] / half_size_m[0],
                                                0.5 * model.tex_height[texture] / half_size_m[1]),
                       .is_pad = texture == pad});
  }
}

void TextureFilter::AdaptTo(const std::optional<FloorFootprint>& footprint, double focal_px) {
  const bool one_depth = footprint && footprint->farthest_m <= kMaxDepthRatio * footprint->nearest_m;
  const double depth_m = one_depth ? std::sqrt(footprint->nearest_m * footprint->farthest_m) : 0.0;
  for (Sheet& sheet : sheets_) {
    std::optional<int> level;
    if (one_depth) level = MipLevel(sheet.texels_per_m, depth_m, focal_px);
    if (sheet.is_pad && level > kLevelOfFullView) level.reset();
    if (level == sheet.level) continue;
    SetParameters(GL_TEXTURE_2D, sheet.texture,
                  {{GL_TEXTURE_BASE_LEVEL, level.value_or(0)},
                   {GL_TEXTURE_MAX_LEVEL, level.value_or(kAllLevels)},
                   {GL_TEXTURE_MIN_FILTER, level ? GL_LINEAR : FilterByPixel(sheet.is_pad)}});
    sheet.level = level;
  }
}

}  // namespace touchdown::sim
