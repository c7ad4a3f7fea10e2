#include "sim/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/angles.h"
#include "models/error.h"
#include "sim/scene/textures.h"

namespace touchdown::sim {
namespace {

using Kind = SceneItem::Kind;

constexpr std::uint64_t kSeeds = 200;

template <typename Check>
void ForEachScene(const Check& check) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    check(MakeScene({}, {}, seed));
  }
}

double DistanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

bool Inside(const SceneItem& item, const Eigen::Vector2d& p) {
  const Eigen::Vector2d offset = p - item.position_m;
  const double x = std::cos(item.yaw) * offset.x() + std::sin(item.yaw) * offset.y();
  const double y = -std::sin(item.yaw) * offset.x() + std::cos(item.yaw) * offset.y();
  return std::abs(x) <= 0.5 * item.size_m.x() && std::abs(y) <= 0.5 * item.size_m.y();
}

double DistanceFromOrigin(const SceneItem& item) {
  if (Inside(item, Eigen::Vector2d::Zero())) return 0.0;
  const auto corners = item.Corners();
  double nearest = corners[0].norm();
  for (std::size_t i = 0; i < 4; ++i) {
    nearest = std::min(nearest, DistanceToSegment(Eigen::Vector2d::Zero(), corners[i], corners[(i + 1) % 4]));
  }
  return nearest;
}

TEST(Scene, HasTheNumbersOfItemsOfItsConfig) {
  ForEachScene([](const Scene& scene) {
    const auto count = [&](auto&&... kinds) {
      return std::count_if(scene.items.begin(), scene.items.end(),
                           [&](const SceneItem& item) { return ((item.kind == kinds) || ...); });
    };
    EXPECT_EQ(count(Kind::kPoster), scene.config.posters);
    EXPECT_EQ(count(Kind::kRing), scene.config.lone_circles);
    EXPECT_EQ(count(Kind::kLetterH), scene.config.lone_letters);
    EXPECT_EQ(count(Kind::kBox, Kind::kCylinder), scene.config.objects);
  });
}

TEST(Scene, ItemsOverlapNeitherThePadNorEachOther) {
  ForEachScene([](const Scene& scene) {
    const SceneItem sheet{.size_m = {scene.pad.sheet_length_m, scene.pad.sheet_width_m, 0.0}};
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
      EXPECT_FALSE(Overlap(scene.items[i], sheet, 0.0));
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(Overlap(scene.items[i], scene.items[j], 0.0));
    }
  });
}

TEST(Scene, HasNoCornerOfAnItemInsideAnother) {
  ForEachScene([](const Scene& scene) {
    for (const SceneItem& item : scene.items) {
      for (const SceneItem& other : scene.items) {
        if (&item == &other) continue;
        for (const Eigen::Vector2d& corner : item.Corners()) EXPECT_FALSE(Inside(other, corner));
      }
    }
  });
}

TEST(Scene, KeepsSolidObjectsOutOfTheFlightPath) {
  ForEachScene([](const Scene& scene) {
    for (const SceneItem& item : scene.items) {
      EXPECT_TRUE(item.IsFlat() || DistanceFromOrigin(item) >= kSolidKeepOut_m);
    }
  });
}

TEST(Scene, PlacesMostFlatItemsNearThePad) {
  ForEachScene([](const Scene& scene) {
    const auto near = std::count_if(scene.items.begin(), scene.items.end(), [](const SceneItem& item) {
      return item.IsFlat() && item.position_m.norm() < 1.6;
    });
    EXPECT_GE(near, 14);
  });
}

TEST(Scene, KeepsItemsOnItsFloor) {
  ForEachScene([](const Scene& scene) {
    for (const SceneItem& item : scene.items) {
      for (const Eigen::Vector2d& corner : item.Corners()) {
        EXPECT_LE(corner.cwiseAbs().maxCoeff(), 0.5 * scene.config.floor_size_m);
      }
    }
  });
}

TEST(Scene, DependsOnItsSeedOnly) {
  const Scene first = MakeScene({}, {}, 7), again = MakeScene({}, {}, 7), other = MakeScene({}, {}, 8);
  ASSERT_EQ(first.items.size(), again.items.size());
  for (std::size_t i = 0; i < first.items.size(); ++i) {
    EXPECT_EQ(first.items[i].position_m, again.items[i].position_m);
    EXPECT_EQ(first.items[i].texture_seed, again.items[i].texture_seed);
    EXPECT_NE(first.items[i].position_m, other.items[i].position_m);
  }
}

TEST(Scene, RejectsMoreItemsThanFitOnItsFloor) {
  EXPECT_THROW(
      MakeScene({.floor_size_m = 4.0, .posters = 40, .lone_circles = 20, .lone_letters = 0, .objects = 20}, {}, 1),
      InputError);
}

TEST(SceneConfig, RejectsInvalidValues) {
  EXPECT_NO_THROW(SceneConfig{}.Validate());
  EXPECT_THROW(SceneConfig{.floor_size_m = 1.0}.Validate(), InputError);
  EXPECT_THROW(SceneConfig{.floor_size_m = std::nan("")}.Validate(), InputError);
  EXPECT_THROW(SceneConfig{.posters = -1}.Validate(), InputError);
  EXPECT_THROW((SceneConfig{.posters = 40, .lone_circles = 40, .lone_letters = 1}).Validate(), InputError);
  EXPECT_THROW(SceneConfig{.illumination = 0.0}.Validate(), InputError);
  EXPECT_THROW(SceneConfig{.illumination = std::nan("")}.Validate(), InputError);
}

TEST(Overlap, MeasuresTheGapBetweenRotatedRectangles) {
  const SceneItem square{.size_m = {2.0, 2.0, 0.0}};
  const SceneItem diamond{.position_m = {2.5, 0.0}, .yaw = 0.25 * models::kPi, .size_m = {2.0, 2.0, 0.0}};
  const double gap = 2.5 - 1.0 - std::sqrt(2.0);
  EXPECT_FALSE(Overlap(square, diamond, gap - 1e-9));
  EXPECT_TRUE(Overlap(square, diamond, gap + 1e-9));
}

TEST(RoomLight, IsUnevenButWithinItsBounds) {
  ForEachScene([](const Scene& scene) {
    const RoomLight light(scene);
    EXPECT_DOUBLE_EQ(light.At(Eigen::Vector2d::Zero()), 1.0);
    double least = 1.0, most = 1.0;
    for (double x = -5.0; x <= 5.0; x += 0.5) {
      for (double y = -5.0; y <= 5.0; y += 0.5) {
        least = std::min(least, light.At({x, y}));
        most = std::max(most, light.At({x, y}));
      }
    }
    EXPECT_GE(least, 0.75);
    EXPECT_LE(most, 1.12);
    EXPECT_GT(most - least, 0.01);
  });
}

}  // namespace
}  // namespace touchdown::sim
