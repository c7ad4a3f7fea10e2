#include "sim/scene/textures.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "models/angles.h"
#include "models/random_stream.h"
#include "sim/scene/artwork.h"
#include "sim/scene/floor_pattern.h"
#include "sim/scene/grass_pattern.h"
#include "sim/scene/shadow_mask.h"
#include "sim/scene/shadow_outline.h"
#include "sim/scene/solid.h"

namespace touchdown::sim {
namespace {

constexpr int kLargeSheetTexels = 512;
constexpr int kSmallSheetTexels = 256;
constexpr double kLargeSheet_m = 0.2;
constexpr int kFaceTexels = 64;
constexpr int kLightCells = 32;

/// Pose and extent of a texture on the floor.
class Placement {
 public:
  explicit Placement(const Eigen::Vector2d& extent_m) : Placement(Eigen::Vector2d::Zero(), 0.0, extent_m) {}

  Placement(const Eigen::Vector2d& center_m, double yaw, const Eigen::Vector2d& extent_m)
      : center_m_(center_m), extent_m_(extent_m), cos_yaw_(std::cos(yaw)), sin_yaw_(std::sin(yaw)) {}

  Eigen::Vector2d TexelCenter(int column, int row, int width, int height) const {
    const double x = ((column + 0.5) / width - 0.5) * extent_m_.x();
    const double y = (0.5 - (row + 0.5) / height) * extent_m_.y();
    return center_m_ + Eigen::Vector2d(cos_yaw_ * x - sin_yaw_ * y, sin_yaw_ * x + cos_yaw_ * y);
  }

  /// Inverse of TexelCenter: column and row, which are integers at a texel's center.
  Eigen::Vector2d TexelAt(const Eigen::Vector2d& p_W, const cv::Size& size) const {
    const Eigen::Vector2d p = p_W - center_m_;
    const double x = cos_yaw_ * p.x() + sin_yaw_ * p.y(), y = cos_yaw_ * p.y() - sin_yaw_ * p.x();
    return {size.width * (x / extent_m_.x() + 0.5) - 0.5, size.height * (0.5 - y / extent_m_.y()) - 0.5};
  }

 private:
  Eigen::Vector2d center_m_, extent_m_;
  double cos_yaw_, sin_yaw_;
};

/// Ratios of green and blue to red.
struct Tint {
  double green = 1.0;
  double blue = 1.0;
};

/// Fills the textures of a model. The camera uses the red channel only; green and blue are for human viewers.
class Painter {
 public:
  Painter(const Scene& scene, mjModel& model) : scene_(scene), model_(model), room_light_(scene) {
    if (scene.config.IsOutdoor()) CastShadows();
  }

  void PaintFlat(const std::string& name, const Placement& placement, const Tint& tint, const cv::Mat1b& artwork) {
    Write(name, tint, cv::Mat1f(cv::Mat1f(artwork).mul(LightOver(placement, artwork.size()))));
  }

  void PaintSolidItem(const std::string& name, const Tint& tint, const cv::Mat1b& faces) { Write(name, tint, faces); }

  void PaintGrass(const std::string& name, const TextureSize& size, double size_m, const GrassPattern& pattern) {
    const Placement placement(Eigen::Vector2d::Constant(size_m));
    const cv::Mat3b grass = pattern.Paint(size_m, size.width);
    cv::Mat light, lit;
    const cv::Mat1f light_over = LightOver(placement, grass.size());
    cv::merge(std::vector<cv::Mat>(3, light_over), light);
    grass.convertTo(lit, CV_32F);
    cv::Mat(lit.mul(light)).convertTo(Texels(name, grass.size()), CV_8U, scene_.config.illumination);
  }

  void PaintFloor(const std::string& name, const TextureSize& size, double size_m, const FloorPattern& pattern) {
    const Placement placement(Eigen::Vector2d::Constant(size_m));
    cv::Mat1b floor(size.height, size.width);
    for (int row = 0; row < floor.rows; ++row) {
      for (int column = 0; column < floor.cols; ++column) {
        const double level = pattern.At(placement.TexelCenter(column, row, floor.cols, floor.rows));
        floor(row, column) = cv::saturate_cast<std::uint8_t>(level);
      }
    }
    PaintFlat(name, placement, {pattern.green(), pattern.blue()}, floor);
  }

 private:
  void CastShadows() {
    for (const SceneItem& item : scene_.items) {
      if (!item.IsFlat()) shadows_.push_back(ShadowOutline(SolidOf(item), scene_.config.sun.Direction()));
    }
  }

  cv::Mat1f LightOver(const Placement& placement, const cv::Size& size) const {
    return scene_.config.IsOutdoor() ? SunOver(placement, size) : RoomLightOver(placement, size);
  }

  cv::Mat1f SunOver(const Placement& placement, const cv::Size& size) const {
    const auto texel_at = [&](const Eigen::Vector2d& p_W) { return placement.TexelAt(p_W, size); };
    cv::Mat1b shadow(size, 0);
    for (const auto& outline : shadows_) FillOutline(outline, texel_at, 255, shadow);
    cv::Mat1f light;
    shadow.convertTo(light, CV_32F, (scene_.config.sun.Shade() - 1.0) / 255.0, 1.0);
    return light;
  }

  /// The room's light is smooth, so it is sampled on a coarse grid and interpolated over the texture.
  cv::Mat1f RoomLightOver(const Placement& placement, const cv::Size& size) const {
    cv::Mat1f coarse(kLightCells, kLightCells), light;
    for (int row = 0; row < kLightCells; ++row) {
      for (int column = 0; column < kLightCells; ++column) {
        coarse(row, column) =
            static_cast<float>(room_light_.At(placement.TexelCenter(column, row, kLightCells, kLightCells)));
      }
    }
    cv::resize(coarse, light, size, 0, 0, cv::INTER_LINEAR);
    return light;
  }

  void Write(const std::string& name, const Tint& tint, const cv::Mat& level) {
    const double gain = scene_.config.illumination;
    std::array<cv::Mat, 3> channels;
    level.convertTo(channels[0], CV_8U, gain);
    level.convertTo(channels[1], CV_8U, gain * tint.green);
    level.convertTo(channels[2], CV_8U, gain * tint.blue);
    cv::merge(channels.data(), channels.size(), Texels(name, level.size()));
  }

  /// The texture's texels, in the memory of the model.
  cv::Mat Texels(const std::string& name, const cv::Size& size) {
    const int texture = mj_name2id(&model_, mjOBJ_TEXTURE, name.c_str());
    if (texture < 0 || size.width != model_.tex_width[texture] || size.height != model_.tex_height[texture]) {
      throw std::logic_error("the model has no texture " + name + " of this size: it belongs to another scene");
    }
    return {size, CV_8UC3, model_.tex_rgb + model_.tex_adr[texture]};
  }

  const Scene& scene_;
  mjModel& model_;
  RoomLight room_light_;
  std::vector<std::vector<Eigen::Vector2d>> shadows_;
};

Tint TintFor(const SceneItem& item) {
  if (item.IsFlat() && item.kind != SceneItem::Kind::kPoster) return {};
  models::RandomStream random(item.texture_seed, "tint");
  return {random.Uniform(0.7, 1.3), random.Uniform(0.7, 1.3)};
}

}  // namespace

TextureSize FloorTexture(const SceneConfig& config) {
  const int texels = config.IsOutdoor() ? 1024 : 512;
  return {.width = texels, .height = texels};
}

TextureSize FloorCenterTexture(const SceneConfig& config) {
  const int texels = config.IsOutdoor() ? 2048 : 1024;
  return {.width = texels, .height = texels};
}

TextureSize SizeFor(const SceneItem& item) {
  if (!item.IsFlat()) return {.cube = true, .width = kFaceTexels, .height = kFaceTexels};
  const int texels = item.size_m.maxCoeff() > kLargeSheet_m ? kLargeSheetTexels : kSmallSheetTexels;
  return {.width = texels, .height = texels};
}

TextureSize PadTextureSize(const models::LandingPad& pad) {
  constexpr double kLongestTexel_m = 0.0002;
  constexpr int kMultiple = 64;
  constexpr int kMaxTexels = 4096;
  const double longer_m = std::max(pad.sheet_length_m, pad.sheet_width_m);
  const double cells =
      std::min(std::ceil(longer_m / (kMultiple * kLongestTexel_m)), static_cast<double>(kMaxTexels) / kMultiple);
  const double texel_m = longer_m / (kMultiple * cells);
  const auto texels = [texel_m](double extent_m) {
    return kMultiple * std::max(1, static_cast<int>(std::lround(extent_m / (kMultiple * texel_m))));
  };
  return {.width = texels(pad.sheet_length_m), .height = texels(pad.sheet_width_m)};
}

std::string ItemName(std::size_t index) { return fmt::format("item_{}", index); }

double PaperLevel(const Scene& scene) { return std::min(255.0, kPaper * scene.config.illumination); }

RoomLight::RoomLight(const Scene& scene) {
  models::RandomStream random(scene.floor_seed, "light");
  for (Pool& pool : pools_) {
    pool.center_m = {random.Uniform(-2.5, 2.5), random.Uniform(-2.5, 2.5)};
    pool.radius_m = random.Uniform(0.7, 2.0);
    pool.gain = random.Uniform(-0.20, 0.20);
  }
  const double heading = random.Uniform(-models::kPi, models::kPi);
  slope_ = random.Uniform(0.02, 0.12) * Eigen::Vector2d(std::cos(heading), std::sin(heading));
}

double RoomLight::Raw(const Eigen::Vector2d& p_W) const {
  double light = slope_.dot(p_W);
  for (const Pool& pool : pools_) {
    light += pool.gain * std::exp(-0.5 * (p_W - pool.center_m).squaredNorm() / (pool.radius_m * pool.radius_m));
  }
  return light;
}

double RoomLight::At(const Eigen::Vector2d& p_W) const {
  const double change = Raw(p_W) - Raw(Eigen::Vector2d::Zero());
  return change > 0.0 ? 1.0 + 0.12 * std::tanh(change / 0.12) : 1.0 + 0.25 * std::tanh(change / 0.25);
}

void PaintTextures(const Scene& scene, mjModel_& model) {
  Painter painter(scene, model);
  const TextureSize floor = FloorTexture(scene.config), center = FloorCenterTexture(scene.config);
  if (scene.config.IsOutdoor()) {
    const GrassPattern grass(scene.floor_seed, scene.pad);
    painter.PaintGrass("floor", floor, scene.config.floor_size_m, grass);
    painter.PaintGrass("floor_center", center, kFloorCenterSize_m, grass);
  } else {
    const FloorPattern pattern(scene.floor_seed);
    painter.PaintFloor("floor", floor, scene.config.floor_size_m, pattern);
    painter.PaintFloor("floor_center", center, kFloorCenterSize_m, pattern);
  }
  if (scene.config.pad) {
    const TextureSize size = PadTextureSize(scene.pad);
    const Placement placement({scene.pad.sheet_length_m, scene.pad.sheet_width_m});
    painter.PaintFlat("pad", placement, {}, PaintPad(scene.pad, size.width, size.height));
  }
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const SceneItem& item = scene.items[i];
    const TextureSize size = SizeFor(item);
    if (item.IsFlat()) {
      painter.PaintFlat(ItemName(i), {item.position_m, item.yaw, item.size_m.head<2>()}, TintFor(item),
                        PaintSheet(item, size.width, size.height));
    } else {
      painter.PaintSolidItem(ItemName(i), TintFor(item), PaintSolid(item, size.width));
    }
  }
}

}  // namespace touchdown::sim
