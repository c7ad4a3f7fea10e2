// Images of outdoor scenes: sunlight and shadows, grass and path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "models/error.h"
#include "sim/dynamics/world.h"
#include "sim/render/renderer.h"
#include "sim/scene/artwork.h"
#include "sim/scene/grass_pattern.h"
#include "sim/scene/textures.h"
#include "tests/support/rooms.h"
#include "tests/support/worlds.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tests::CameraAt;
using tests::GrayAt;

constexpr SceneConfig::Setting kOutdoor = SceneConfig::Setting::kOutdoor;

SceneConfig Meadow(const Sun& sun, int objects = 0) {
  SceneConfig meadow = tests::EmptyRoomConfig();
  meadow.setting = kOutdoor;
  meadow.objects = objects;
  meadow.sun = sun;
  return meadow;
}

/// Renders a meadow with the vehicle above it.
class MeadowTest : public ::testing::Test {
 protected:
  static constexpr Sun kSun{.elevation_deg = 60.0, .azimuth_deg = 30.0, .to_sky = 3.0};

  World& Make(const SceneConfig& config) {
    scene_ = MakeScene(config, {}, 1);
    world_ = std::make_unique<World>(WorldConfig{}, models::Vehicle{}, scene_, models::TimeBase{}, 1);
    renderer_ = std::make_unique<Renderer>(world_->model(), PinholeView{});
    return *world_;
  }

  /// Gray level of the point p_W, seen from straight above, with the vehicle's body at p_WB.
  double GrayOf(const Vector3d& p_W, const Vector3d& p_WB) {
    world_->Reset(Eigen::Isometry3d(Eigen::Translation3d(p_WB)), true);
    const Eigen::Isometry3d X_WC = CameraAt(p_W + Vector3d(0.0, 0.0, 0.4));
    return GrayAt(renderer_->Render(world_->data(), X_WC), {319.5, 239.5});
  }

  /// Gray level of the point p_W with the vehicle at p_WB, divided by the level with the vehicle far away.
  double RelativeGray(const Vector3d& p_W, const Vector3d& p_WB) { return GrayOf(p_W, p_WB) / GrayOf(p_W, far_away_); }

  const Vector3d far_away_ = {3.0, 3.0, 1.0};
  Scene scene_;
  std::unique_ptr<World> world_;
  std::unique_ptr<Renderer> renderer_;
};

/// Position at `height_m` whose shadow falls on p_W.
Vector3d PositionShading(const Vector3d& p_W, double height_m, const Sun& sun) {
  const double reach = height_m / std::tan(models::DegToRad(sun.elevation_deg));
  const double azimuth = models::DegToRad(sun.azimuth_deg);
  return p_W + Vector3d(reach * std::cos(azimuth), reach * std::sin(azimuth), height_m);
}

const Vector3d kOnPaper(0.03, 0.0, 0.0);

TEST_F(MeadowTest, PaperInTheSunIsAsBrightAsIndoors) {
  Make(Meadow(kSun));
  EXPECT_NEAR(GrayOf(kOnPaper, far_away_), PaperLevel(scene_), 2.5);
}

TEST_F(MeadowTest, TheHullsShadowRemovesTheSunlight) {
  for (const double to_sky : {0.5, 3.0}) {
    Sun sun = kSun;
    sun.to_sky = to_sky;
    Make(Meadow(sun));
    for (const double height : {0.3, 1.0}) {
      const Vector3d body = PositionShading(kOnPaper, height, sun);
      EXPECT_NEAR(RelativeGray(kOnPaper, body), 1.0 / (1.0 + to_sky), 0.015) << "hull, battery and camera darken once";
      EXPECT_NEAR(RelativeGray(kOnPaper, body + Vector3d(0.0, 0.8, 0.0)), 1.0, 0.01);
      EXPECT_NEAR(RelativeGray(kOnPaper, PositionShading(kOnPaper, height,
                                                         {.elevation_deg = sun.elevation_deg,
                                                          .azimuth_deg = sun.azimuth_deg + 178.0})),
                  1.0, 0.01)
          << "on the sun's side";
    }
  }
}

TEST_F(MeadowTest, ASpinningRotorBlocksTheFractionThatItsBladesCover) {
  Make(Meadow(kSun));
  const models::Vehicle vehicle;
  const Vector3d hub = vehicle.RotorPosition(0);
  const Vector3d outwards(0.09 * std::sqrt(0.5) * hub.x() / std::abs(hub.x()),
                          0.09 * std::sqrt(0.5) * hub.y() / std::abs(hub.y()), 0.0);
  const Vector3d body = PositionShading(kOnPaper, 0.5, kSun) - hub - outwards;
  EXPECT_NEAR(RelativeGray(kOnPaper, body), 1.0 - 0.12 * 0.75, 0.015);
}

TEST_F(MeadowTest, HasNoShadowUnderAnOvercastSkyOrIndoors) {
  Make(Meadow({.to_sky = 0.0}));
  EXPECT_EQ(RelativeGray(kOnPaper, PositionShading(kOnPaper, 0.3, {})), 1.0);
  Make(tests::EmptyRoomConfig());
  EXPECT_EQ(RelativeGray(kOnPaper, PositionShading(kOnPaper, 0.3, {})), 1.0);
}

/// The shadow is the ratio of the gray levels of the same ground under the sun and under an overcast sky.
TEST_F(MeadowTest, OverlappingShadowsOfObjectAndVehicleDarkenOnce) {
  Make(Meadow(kSun, 12));
  const SceneItem tall = *std::max_element(scene_.items.begin(), scene_.items.end(),
                                           [](const auto& a, const auto& b) { return a.size_m.z() < b.size_m.z(); });
  // Shadow of a point on the object's axis, well within the shadow and outside the object itself.
  const Vector3d axis(tall.position_m.x(), tall.position_m.y(), 0.0);
  const Vector3d away = -PositionShading(Vector3d::Zero(), 1.0, kSun);
  const Vector3d shaded = axis + Vector3d(away.x(), away.y(), 0.0).normalized() *
                                     (0.5 * tall.size_m.head<2>().minCoeff() + 0.35 * tall.size_m.z());
  const double in_shade = GrayOf(shaded, far_away_);
  EXPECT_NEAR(RelativeGray(shaded, PositionShading(shaded, 1.5, kSun)), 1.0, 0.05);
  Sun overcast = kSun;
  overcast.to_sky = 0.0;
  Make(Meadow(overcast, 12));
  EXPECT_NEAR(in_shade / GrayOf(shaded, far_away_), kSun.Shade(), 0.06);
}

TEST_F(MeadowTest, AnObjectHidesTheVehiclesShadowBehindIt) {
  Make(Meadow(kSun, 12));
  const SceneItem& object = scene_.items.front();
  const Vector3d top(object.position_m.x(), object.position_m.y(), 0.0);
  EXPECT_EQ(RelativeGray(top, PositionShading(top, 1.5, kSun)), 1.0);
}

TEST(OutdoorScene, HasOutdoorObjectsOutsideTheFlightPath) {
  int stones = 0, balls = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Scene scene = MakeScene({.setting = kOutdoor}, {}, seed);
    for (const SceneItem& item : scene.items) {
      stones += item.kind == SceneItem::Kind::kStone ? 1 : 0;
      balls += item.kind == SceneItem::Kind::kBall ? 1 : 0;
      if (item.IsFlat()) continue;
      EXPECT_GE(item.position_m.norm() - 0.5 * item.size_m.head<2>().norm(), kSolidKeepOut_m - 1e-9);
    }
  }
  EXPECT_GT(stones, 100);
  EXPECT_GT(balls, 20);
}

TEST(OutdoorScene, TheSunHasNoEffectIndoors) {
  SceneConfig low{.sun = {.elevation_deg = 17.0, .azimuth_deg = 115.0, .to_sky = 8.0}};
  const tests::Room room({}, 4), under_another_sun(low, 4);
  for (const double height : {0.5, 1.5}) {
    const Eigen::Isometry3d X_WC = CameraAt({0.1, 0.0, height}, {.roll = 0.3, .pitch = 0.1, .yaw = 0.2});
    EXPECT_EQ(Renderer(*room.model, {}).Render(*room.data, X_WC).pixels,
              Renderer(*under_another_sun.model, {}).Render(*under_another_sun.data, X_WC).pixels);
  }
}

TEST(OutdoorScene, EndsInABrightSky) {
  const tests::Room meadow(Meadow({}));
  Renderer renderer(*meadow.model, {});
  const models::Image& image =
      renderer.Render(*meadow.data, CameraAt({0.0, 0.0, 1.0}, {.roll = 0.0, .pitch = -1.4, .yaw = 0.0}));
  EXPECT_GT(image.View().At(320, 5), 150);
  EXPECT_LT(image.View().At(320, 474), 150) << "grass below the sky";
}

TEST(GrassPattern, HasAPathThatAvoidsThePadsSheet) {
  const models::LandingPad pad;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const GrassPattern grass(seed, pad);
    int on_path = 0;
    for (double x = -1.5; x <= 1.5; x += 0.02) {
      for (double y = -1.5; y <= 1.5; y += 0.02) {
        const bool is_path = grass.IsPath({x, y});
        on_path += is_path ? 1 : 0;
        if (std::abs(x) < 0.5 * pad.sheet_length_m + 0.02 && std::abs(y) < 0.5 * pad.sheet_width_m + 0.02) {
          ASSERT_FALSE(is_path) << seed;
        }
      }
    }
    EXPECT_GT(on_path * 0.02 * 0.02, 0.3) << "m^2 of path near the pad, seed " << seed;
  }
}

TEST(GrassPattern, IsGreenAndDarkerThanPaperAndTheSameForTheSameSeed) {
  const GrassPattern grass(3, {}), again(3, {}), other(4, {});
  const cv::Mat3b texture = grass.Paint(3.0, 512);
  const cv::Scalar mean = cv::mean(texture);
  EXPECT_GT(mean[1], mean[0]);
  EXPECT_GT(mean[0], mean[2]);
  EXPECT_LT(mean[0], 0.6 * kPaper);
  EXPECT_EQ(cv::norm(texture, again.Paint(3.0, 512)), 0.0);
  EXPECT_GT(cv::norm(texture, other.Paint(3.0, 512)), 0.0);
}

TEST(GrassPattern, IsAsBrightWithBladesAsWithout) {
  for (const std::uint64_t seed : {1, 2}) {
    const GrassPattern grass(seed, {});
    const cv::Scalar coarse = cv::mean(grass.Paint(3.0, 512)), fine = cv::mean(grass.Paint(3.0, 1536));
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(fine[channel] / coarse[channel], 1.0, 0.1);
  }
}

TEST(Sun, RejectsInvalidValues) {
  EXPECT_NO_THROW(Sun{}.Validate());
  EXPECT_THROW(Sun{.elevation_deg = 9.0}.Validate(), InputError);
  EXPECT_THROW(Sun{.elevation_deg = 91.0}.Validate(), InputError);
  EXPECT_THROW(Sun{.azimuth_deg = std::nan("")}.Validate(), InputError);
  EXPECT_THROW(Sun{.to_sky = -0.1}.Validate(), InputError);
}

}  // namespace
}  // namespace touchdown::sim
