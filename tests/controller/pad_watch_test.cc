#include "controller/pad_watch.h"

#include <gtest/gtest.h>

namespace touchdown::controller {
namespace {

constexpr PadWatch::Settings kSettings{.lost_after = 300, .found_after = 100, .fresh_for = 60};

TEST(PadWatch, IsLostWithoutDetection) {
  PadWatch watch(kSettings);
  watch.Update(1000, {});
  EXPECT_TRUE(watch.lost());
  EXPECT_FALSE(watch.found());
  EXPECT_FALSE(watch.fresh());
}

TEST(PadWatch, IsFoundAfterEnoughDetections) {
  PadWatch watch(kSettings);
  for (models::Tick seen = 0; seen <= 80; seen += 20) {
    watch.Update(seen + 25, seen);
    EXPECT_FALSE(watch.lost());
    EXPECT_FALSE(watch.found()) << seen;
  }
  watch.Update(125, 100);
  EXPECT_TRUE(watch.found());
  EXPECT_TRUE(watch.fresh());
}

TEST(PadWatch, IgnoresAgeOfSingleDetection) {
  PadWatch watch(kSettings);
  for (models::Tick tick = 25; tick < 300; tick += 5) {
    watch.Update(tick, 0);
    EXPECT_FALSE(watch.found());
  }
}

TEST(PadWatch, IsLostOnlyAfterLostTime) {
  PadWatch watch(kSettings);
  watch.Update(0, 0);
  watch.Update(100, 100);
  watch.Update(160, 100);
  EXPECT_TRUE(watch.fresh());
  watch.Update(161, 100);
  EXPECT_FALSE(watch.fresh());
  watch.Update(400, 100);
  EXPECT_TRUE(watch.found());
  watch.Update(401, 100);
  EXPECT_TRUE(watch.lost());
  EXPECT_FALSE(watch.found());
}

TEST(PadWatch, RestartsAfterLossButNotAfterShortGap) {
  PadWatch watch(kSettings);
  watch.Update(0, 0);
  watch.Update(100, 100);
  watch.Update(380, 360);
  EXPECT_TRUE(watch.found());
  watch.Update(1000, 980);
  EXPECT_FALSE(watch.lost());
  EXPECT_FALSE(watch.found());
  watch.Update(1100, 1080);
  EXPECT_TRUE(watch.found());
}

}  // namespace
}  // namespace touchdown::controller
