#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flight_rig.h"

namespace touchdown::controller {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using tests::Fly;
using tests::HoverAt;
using tests::Land;
using tests::QuadrotorOde;
using tests::RigConfig;
using tests::RigResult;
using tests::TakeoffTo;

constexpr std::uint64_t kSeeds = 50;

RigConfig TakeoffHoverLand(std::uint64_t seed) {
  RigConfig config;
  config.seed = seed;
  config.script = {TakeoffTo(1.0), HoverAt({0.0, 0.0, 1.0}, 5.0), Land()};
  return config;
}

RigConfig LandingFromAside(std::uint64_t seed) {
  RigConfig config;
  config.seed = seed;
  config.script = {Land()};
  config.starts_airborne = true;
  config.start_m = {0.24, 0.18, 1.5};
  return config;
}

void ExpectLanded(const RigResult& result, std::uint64_t seed) {
  EXPECT_FALSE(result.crashed) << "seed " << seed;
  EXPECT_EQ(result.last_phase, Phase::kTouchdown) << "seed " << seed;
  ASSERT_TRUE(result.touchdown.has_value()) << "seed " << seed;
  EXPECT_LT(result.touchdown->xy_m, 0.060) << "seed " << seed;
  EXPECT_LT(result.touchdown->speed_m_s, 0.50) << "seed " << seed;
  EXPECT_LT(result.touchdown->tilt_rad, DegToRad(10.0)) << "seed " << seed;
  EXPECT_LT(std::abs(result.touchdown->yaw_rad), DegToRad(8.0)) << "seed " << seed;
}

TEST(ManyFlights, TakeOffHoverAndLand) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RigResult result = Fly(TakeoffHoverLand(seed));
    ExpectLanded(result, seed);
    ASSERT_TRUE(result.reached_height_s.has_value());
    EXPECT_LT(*result.reached_height_s, 6.0) << "seed " << seed;
    EXPECT_LT(result.hover_rmse_m, 0.10) << "seed " << seed;
    EXPECT_LT(result.landing_s, 6.0) << "seed " << seed;
  }
}

TEST(ManyFlights, LandFromOffsetWithUnknownGyroBias) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) ExpectLanded(Fly(LandingFromAside(seed)), seed);
}

TEST(ManyFlights, LandWithMassError) {
  for (const double ratio : {0.95, 1.05}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      RigConfig config = TakeoffHoverLand(seed);
      config.mass_ratio = ratio;
      ExpectLanded(Fly(config), seed);
    }
  }
}

TEST(ManyFlights, LandWhenWindRisesDuringFlight) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RigConfig config = TakeoffHoverLand(seed);
    config.events = [](double t, QuadrotorOde& truth) {
      if (t > 6.0) truth.wind = {2.1, 2.1, 0.0};
      return true;
    };
    ExpectLanded(Fly(config), seed);
  }
}

TEST(ManyFlights, LandFromAnyHeading) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RigConfig config = TakeoffHoverLand(seed);
    config.start_yaw = DegToRad(-60.0 + 120.0 * static_cast<double>(seed) / kSeeds);
    ExpectLanded(Fly(config), seed);
  }
}

TEST(ManyFlights, HoverDespitePushes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RigConfig config;
    config.seed = seed;
    config.script = {TakeoffTo(1.0), HoverAt({0.0, 0.0, 1.0}, 60.0)};
    config.time_limit_s = 80.0;
    config.events = [](double t, QuadrotorOde& truth) {
      const double since_s = std::fmod(t, 10.0);
      const double direction = 2.4 * std::floor(t / 10.0);
      const bool pushed = t > 10.0 && since_s < 0.6;
      truth.push_n = pushed ? Vector3d(2.5 * std::cos(direction), 2.5 * std::sin(direction), 0.0) : Vector3d::Zero();
      return true;
    };
    const RigResult result = Fly(config);
    EXPECT_TRUE(result.script_done) << "seed " << seed;
    EXPECT_EQ(result.last_phase, Phase::kHover) << "seed " << seed;
    EXPECT_GT(result.max_offset_m, 0.30) << "seed " << seed;
    EXPECT_LT(result.max_offset_m, 0.80) << "seed " << seed;
    EXPECT_LT(result.hover_rmse_m, 0.20) << "seed " << seed;
  }
}

}  // namespace
}  // namespace touchdown::controller
