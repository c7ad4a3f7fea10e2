#include "sim/render/renderer.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/camera_model.h"
#include "sim/render/floor_footprint.h"
#include "sim/scene/artwork.h"
#include "sim/scene/geom_groups.h"
#include "sim/scene/textures.h"
#include "tests/support/rooms.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tests::CameraAt;
using tests::CameraTowards;
using tests::EdgeOffset;
using tests::EmptyRoomConfig;
using tests::GrayAt;
using tests::Room;

const models::CameraModel kPinhole{.k1 = 0.0, .k2 = 0.0};

Vector2d PixelOf(const Vector3d& p_W, const Eigen::Isometry3d& X_WC) {
  return kPinhole.Project(X_WC.inverse() * p_W).value();
}

const std::vector<Eigen::Isometry3d>& Views() {
  static const std::vector<Eigen::Isometry3d> views{
      CameraAt({0.0, 0.0, 0.3}),
      CameraTowards({0.05, -0.03, 0.4}, {0.1, 0.1}, 0.7),
      CameraTowards({0.25, 0.1, 0.3}, {0.0, 0.05}, -0.3),
      CameraTowards({-0.15, 0.25, 0.25}, {-0.1, 0.05}, 2.0),
  };
  return views;
}

TEST(Renderer, RendersTheRingAtItsPinholeProjection) {
  const Room room(EmptyRoomConfig());
  Renderer renderer(*room.model, {});
  for (const Eigen::Isometry3d& X_WC : Views()) {
    const models::Image& image = renderer.Render(*room.data, X_WC);
    Vector2d mean = Vector2d::Zero();
    double worst = 0.0, sum_of_squares = 0.0;
    for (const double radius : {room.scene.pad.outer_radius_m, room.scene.pad.inner_radius_m()}) {
      for (int i = 0; i < 72; ++i) {
        const Vector3d outward(std::cos(i * models::kPi / 36), std::sin(i * models::kPi / 36), 0.0);
        const Vector2d edge = PixelOf(radius * outward, X_WC);
        const Vector2d direction = (PixelOf((radius + 1e-4) * outward, X_WC) - edge).normalized();
        const double offset = EdgeOffset(image, edge, direction);
        worst = std::max(worst, std::abs(offset));
        sum_of_squares += offset * offset;
        mean += offset / 144.0 * direction;
      }
    }
    EXPECT_LT(std::sqrt(sum_of_squares / 144.0), 0.05);
    EXPECT_LT(worst, 0.15);
    EXPECT_LT(mean.norm(), 0.02);
  }
}

TEST(Renderer, RendersTheLetterAlongTheWorldsX) {
  const Room room(EmptyRoomConfig());
  Renderer renderer(*room.model, {});
  const double x = 0.4 * room.scene.pad.h_height_m;
  const double y = 0.5 * (room.scene.pad.h_width_m - room.scene.pad.h_stroke_m);
  for (const Eigen::Isometry3d& X_WC : Views()) {
    const models::Image& image = renderer.Render(*room.data, X_WC);
    for (const double sign_x : {-1.0, 1.0}) {
      for (const double sign_y : {-1.0, 1.0}) {
        EXPECT_LT(GrayAt(image, PixelOf({sign_x * x, sign_y * y, 0.0}, X_WC)), 60.0);
      }
      EXPECT_GT(GrayAt(image, PixelOf({sign_x * x, 0.0, 0.0}, X_WC)), 180.0);
    }
    EXPECT_LT(GrayAt(image, PixelOf({0.0, 0.0, 0.0}, X_WC)), 60.0);
  }
}

/// The pad's texture is painted white except for one block of texels, because the pad itself would not reveal a texture
/// that is rotated by 180 degrees.
TEST(Renderer, ShowsTheFirstTexelAtTheCornerOfLowXAndHighY) {
  const Room room(EmptyRoomConfig());
  const int texture = mj_name2id(room.model.get(), mjOBJ_TEXTURE, "pad");
  std::uint8_t* rgb = room.model->tex_rgb + room.model->tex_adr[texture];
  const TextureSize size = PadTextureSize({});
  std::fill_n(rgb, 3 * size.width * size.height, std::uint8_t{255});
  for (int row = 0; row < size.height / 4; ++row) {
    std::fill_n(rgb + 3 * row * size.width, 3 * size.width / 4, std::uint8_t{0});
  }
  Renderer renderer(*room.model, {});
  const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 0.4});
  const models::Image& image = renderer.Render(*room.data, X_WC);
  const double x = 0.4 * room.scene.pad.sheet_length_m, y = 0.4 * room.scene.pad.sheet_width_m;
  EXPECT_LT(GrayAt(image, PixelOf({-x, y, 0.0}, X_WC)), 5.0);
  EXPECT_GT(GrayAt(image, PixelOf({x, y, 0.0}, X_WC)), 250.0);
  EXPECT_GT(GrayAt(image, PixelOf({-x, -y, 0.0}, X_WC)), 250.0);
  EXPECT_GT(GrayAt(image, PixelOf({x, -y, 0.0}, X_WC)), 250.0);
}

TEST(Renderer, RendersEveryFlatItemAtItsPose) {
  Room room({.posters = 0, .lone_circles = 0, .lone_letters = 12, .objects = 0}, 3);
  Renderer renderer(*room.model, {});
  for (const SceneItem& item : room.scene.items) {
    const Vector3d center(item.position_m.x(), item.position_m.y(), 0.0);
    const Eigen::Isometry3d X_WC = CameraAt(center + Vector3d(0.0, 0.0, 0.5));
    const models::Image& image = renderer.Render(*room.data, X_WC);
    const Vector3d across(-std::sin(item.yaw), std::cos(item.yaw), 0.0), along(across.y(), -across.x(), 0.0);
    EXPECT_LT(GrayAt(image, PixelOf(center, X_WC)), 100.0);
    EXPECT_GT(GrayAt(image, PixelOf(center + 0.47 * item.size_m.x() * along, X_WC)), 120.0);
    EXPECT_GT(GrayAt(image, PixelOf(center + 0.47 * item.size_m.y() * across, X_WC)), 120.0);
  }
}

TEST(Renderer, HonorsAnOffCenterPrincipalPointWithSubpixelAccuracy) {
  const Room room(EmptyRoomConfig());
  Renderer centered(*room.model, {});
  Renderer shifted(*room.model, {.width_px = 700, .height_px = 520, .cx_px = 347.5, .cy_px = 254.5});
  const Eigen::Isometry3d X_WC = CameraAt({0.02, 0.01, 0.4}, {.roll = 0.1, .pitch = 0.1, .yaw = 0.3});
  const models::Image a = centered.Render(*room.data, X_WC), b = shifted.Render(*room.data, X_WC);
  for (int v = 0; v < 480; v += 7) {
    for (int u = 0; u < 640; u += 7) EXPECT_NEAR(a.View().At(u, v), b.View().At(u + 28, v + 15), 2);
  }
}

TEST(Renderer, RendersInkAndPaperAtTheScenesIllumination) {
  for (const double illumination : {0.3, 1.0, 1.1}) {
    SceneConfig config = EmptyRoomConfig();
    config.illumination = illumination;
    const Room room(config);
    Renderer renderer(*room.model, {});
    const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 0.3});
    const models::Image& image = renderer.Render(*room.data, X_WC);
    EXPECT_NEAR(GrayAt(image, PixelOf({0.03, 0.0, 0.0}, X_WC)), PaperLevel(room.scene), 2.5);
    EXPECT_NEAR(GrayAt(image, PixelOf({0.0, 0.0, 0.0}, X_WC)), kInk * illumination, 2.5);
    EXPECT_NEAR(PaperLevel(room.scene), 225.0 * illumination, 0.1);
  }
}

TEST(Renderer, ShowsThePadCoveredAndBare) {
  const Room room(EmptyRoomConfig());
  Renderer renderer(*room.model, {});
  const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 0.3});
  const models::Image shown = renderer.Render(*room.data, X_WC);
  const int cover = mj_name2id(room.model.get(), mjOBJ_GEOM, kPadCoverName);
  ASSERT_GE(cover, 0);
  room.model->geom_rgba[4 * cover + 3] = 1.0f;
  const models::Image covered = renderer.Render(*room.data, X_WC);
  room.model->geom_rgba[4 * cover + 3] = 0.0f;
  EXPECT_EQ(renderer.Render(*room.data, X_WC).pixels, shown.pixels);
  for (const double x : {-0.08, 0.0, 0.03, 0.08}) {
    EXPECT_NEAR(GrayAt(covered, PixelOf({x, 0.0, 0.0}, X_WC)), PaperLevel(room.scene), 2.5);
  }
}

TEST(Renderer, ShowsNoPadInASceneWithoutAPad) {
  SceneConfig config = EmptyRoomConfig();
  config.pad = false;
  const Room without(config), with(EmptyRoomConfig());
  EXPECT_EQ(mj_name2id(without.model.get(), mjOBJ_GEOM, "pad"), -1);
  with.model->mat_rgba[4 * mj_name2id(with.model.get(), mjOBJ_MATERIAL, "pad") + 3] = 0.0f;
  const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 0.5});
  EXPECT_EQ(Renderer(*without.model, {}).Render(*without.data, X_WC).pixels,
            Renderer(*with.model, {}).Render(*with.data, X_WC).pixels);
}

TEST(Renderer, OmitsOnlySurroundingsHiddenByTheFloorsCenter) {
  const Room room({}, 7);
  Room everything({}, 7);
  for (int geom = 0; geom < everything.model->ngeom; ++geom) {
    int& group = everything.model->geom_group[geom];
    if (group == kSurroundings) group = kScenery;
  }
  Renderer renderer(*room.model, {}), thorough(*everything.model, {});
  for (const double height : {0.15, 0.5, 1.0, 1.45, 1.55, 2.5}) {
    for (const double tilt : {0.0, 0.2, 0.5, 1.2}) {
      const Eigen::Isometry3d X_WC = CameraAt({0.1, -0.2, height}, {.roll = tilt, .pitch = -0.5 * tilt, .yaw = 0.4});
      EXPECT_EQ(renderer.Render(*room.data, X_WC).pixels, thorough.Render(*everything.data, X_WC).pixels)
          << height << " m, " << tilt << " rad";
    }
  }
}

TEST(Renderer, RendersAViewIndependentlyOfEarlierViews) {
  const Room room({}, 6);
  Renderer renderer(*room.model, {});
  for (const Eigen::Isometry3d& X_WC :
       {CameraAt({0.0, 0.0, 1.0}), CameraAt({0.0, 0.0, 0.15}), CameraAt({0.1, 0.0, 1.0}, {.roll = 0.6})}) {
    const models::Image first = Renderer(*room.model, {}).Render(*room.data, X_WC);
    EXPECT_EQ(renderer.Render(*room.data, X_WC).pixels, first.pixels);
    for (const double height : {0.12, 0.5, 2.8}) renderer.Render(*room.data, CameraAt({0.0, 0.0, height}));
    EXPECT_EQ(renderer.Render(*room.data, X_WC).pixels, first.pixels);
  }
}

/// The depths in the wide view differ too much for one mip level, those in its middle do not.
TEST(Renderer, IsAsSharpWithOneMipLevelAsWithALevelPerPixel) {
  const Room room({}, 6);
  constexpr int kWidth = 160, kHeight = 120;
  const PinholeView wide, middle{.width_px = kWidth, .height_px = kHeight, .cx_px = 79.5, .cy_px = 59.5};
  Renderer by_pixel(*room.model, wide), by_frame(*room.model, middle);
  for (const double height : {0.5, 1.0, 1.4}) {
    const Eigen::Isometry3d X_WC = CameraAt({0.2, -0.1, height}, {.roll = 0.25, .pitch = -0.2, .yaw = 0.4});
    ASSERT_GT(FootprintOf(wide, X_WC)->farthest_m, 2.0 * FootprintOf(wide, X_WC)->nearest_m);
    ASSERT_LT(FootprintOf(middle, X_WC)->farthest_m, 2.0 * FootprintOf(middle, X_WC)->nearest_m);
    const models::Image& expected = by_pixel.Render(*room.data, X_WC);
    const models::Image& image = by_frame.Render(*room.data, X_WC);
    double contrast_expected = 0.0, contrast = 0.0;
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 1; u < kWidth; ++u) {
        const auto step_at = [&](const models::Image& in, int du, int dv) {
          return std::abs(in.View().At(u + du, v + dv) - in.View().At(u + du - 1, v + dv));
        };
        contrast_expected += step_at(expected, (640 - kWidth) / 2, (480 - kHeight) / 2);
        contrast += step_at(image, 0, 0);
      }
    }
    EXPECT_NEAR(contrast / contrast_expected, 1.0, 0.2) << height;
  }
}

TEST(Renderer, DoesNotShowTheVehicle) {
  const Room room(EmptyRoomConfig());
  Renderer renderer(*room.model, {});
  const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 1.0});
  const models::Image before = renderer.Render(*room.data, X_WC);
  room.data->qpos[2] = 0.3;
  mj_forward(room.model.get(), room.data.get());
  EXPECT_EQ(renderer.Render(*room.data, X_WC).pixels, before.pixels);
}

TEST(Renderer, RendersTheSamePixelsNextToAnotherRenderer) {
  const Room room({}, 5);
  const Eigen::Isometry3d X_WC = CameraAt({0.1, 0.0, 1.0}, {.roll = 0.1, .pitch = 0.0, .yaw = 0.2});
  Renderer alone(*room.model, {});
  const models::Image first = alone.Render(*room.data, X_WC);
  Renderer beside(*room.model, {.width_px = 320, .height_px = 240, .focal_px = 160.0, .cx_px = 159.5, .cy_px = 119.5});
  beside.Render(*room.data, X_WC);
  EXPECT_EQ(alone.Render(*room.data, X_WC).pixels, first.pixels);
  EXPECT_EQ(Renderer(*room.model, {}).Render(*room.data, X_WC).pixels, first.pixels);
}

TEST(Renderer, RendersAnotherRoomForAnotherSeed) {
  const Room first({}, 1), again({}, 1), other({}, 2);
  const Eigen::Isometry3d X_WC = CameraAt({0.0, 0.0, 1.5});
  const models::Image image = Renderer(*first.model, {}).Render(*first.data, X_WC);
  EXPECT_EQ(Renderer(*again.model, {}).Render(*again.data, X_WC).pixels, image.pixels);
  EXPECT_NE(Renderer(*other.model, {}).Render(*other.data, X_WC).pixels, image.pixels);
}

}  // namespace
}  // namespace touchdown::sim
