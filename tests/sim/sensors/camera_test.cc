#include "sim/sensors/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "models/error.h"
#include "tests/support/nominal.h"

namespace touchdown::sim {
namespace {

using models::CameraFrame;
using models::Tick;
using tests::kTime;

CameraConfig SmallAndRigid() {
  CameraConfig config;
  config.model = {.width_px = 64, .height_px = 48, .fx_px = 32, .fy_px = 32, .cx_px = 31.5, .cy_px = 23.5};
  config.vibration_rad_s2_m = 0.0;
  return config;
}

/// A room with a camera on a vehicle whose state the test sets.
struct CameraRig {
  explicit CameraRig(const CameraConfig& config = SmallAndRigid(), std::uint64_t seed = 1)
      : world({}, vehicle, MakeScene({.posters = 4, .lone_circles = 0, .lone_letters = 0, .objects = 0}, {}, 1), kTime,
              1),
        camera(config, vehicle.X_BC(), world, kTime, seed) {}

  static TrueState Hovering(Tick tick) {
    TrueState state;
    state.tick = tick;
    state.X_WB.translation() = Eigen::Vector3d(0.0, 0.0, 0.5);
    return state;
  }

  struct Delivered {
    Tick at;
    CameraFrame frame;
  };

  /// Frames that the camera delivers over the ticks [0, ticks) when the vehicle has the states `state_at`.
  template <typename StateAt>
  std::vector<Delivered> Run(Tick ticks, const StateAt& state_at) {
    std::vector<Delivered> delivered;
    for (Tick tick = 0; tick < ticks; ++tick) {
      if (auto frame = camera.Sample(state_at(tick))) delivered.push_back({tick, std::move(*frame)});
    }
    return delivered;
  }

  models::Vehicle vehicle;
  World world;
  Camera camera;
};

TEST(Camera, ExposesAtItsRateAndDeliversWithLatency) {
  CameraRig rig;
  const auto delivered = rig.Run(105, CameraRig::Hovering);
  ASSERT_EQ(delivered.size(), 5u);
  for (std::size_t i = 0; i < delivered.size(); ++i) {
    EXPECT_EQ(delivered[i].frame.mid_exposure, static_cast<Tick>(20 * i));
    EXPECT_EQ(delivered[i].at, static_cast<Tick>(20 * i + 24));
    EXPECT_EQ(delivered[i].frame.image.width, 64);
    EXPECT_EQ(delivered[i].frame.image.height, 48);
  }
}

TEST(Camera, DeliversNoFrameBeforeTheShutterHasClosed) {
  CameraConfig config = SmallAndRigid();
  config.latency_ms = 2.0;
  config.rate_hz = 30;
  CameraRig rig(config);
  const auto delivered = rig.Run(50, CameraRig::Hovering);
  ASSERT_EQ(delivered.size(), 2u);
  EXPECT_EQ(delivered[1].frame.mid_exposure, 40);
  EXPECT_EQ(delivered[1].at, 43);
}

TEST(Camera, RendersFromThePoseAtMidExposure) {
  CameraConfig config = SmallAndRigid();
  config.noise_sigma = 0.0;
  config.exposure_ms = 0.0;
  const auto moving = [](Tick tick) {
    TrueState state = CameraRig::Hovering(tick);
    state.X_WB.translation().x() = 0.002 * static_cast<double>(tick);
    return state;
  };
  CameraRig rig(config), still(config);
  const auto delivered = rig.Run(50, moving);
  const auto expected = still.Run(50, [&](Tick tick) {
    TrueState state = moving(20);
    state.tick = tick;
    return state;
  });
  ASSERT_EQ(delivered.size(), 2u);
  EXPECT_EQ(delivered[1].frame.mid_exposure, 20);
  EXPECT_EQ(delivered[1].frame.image.pixels, expected[1].frame.image.pixels);
  EXPECT_NE(delivered[0].frame.image.pixels, expected[0].frame.image.pixels);
}

TEST(Camera, BlursOverItsExposure) {
  CameraConfig config;
  config.noise_sigma = 0.0;
  config.vibration_rad_s2_m = 0.0;
  const auto contrast = [](const CameraFrame& frame) {
    double sum = 0.0;
    for (int v = 0; v < frame.image.height; ++v) {
      for (int u = 1; u < frame.image.width; ++u) {
        const double step = frame.image.View().At(u, v) - frame.image.View().At(u - 1, v);
        sum += step * step;
      }
    }
    return sum;
  };
  const auto sliding = [](Tick tick) {
    TrueState state = CameraRig::Hovering(tick);
    state.X_WB.translation().y() = 0.002 * static_cast<double>(tick - 20);
    return state;
  };
  CameraRig blurred(config);
  config.exposure_ms = 0.0;
  CameraRig sharp(config);
  const auto with = blurred.Run(46, sliding), without = sharp.Run(46, sliding);
  EXPECT_LT(contrast(with[1].frame), 0.6 * contrast(without[1].frame));
}

TEST(Camera, TiltsWithTheVibrationOfItsMount) {
  CameraConfig config = SmallAndRigid();
  config.vibration_rad_s2_m = 0.002;
  CameraRig rig(config);
  TrueState state = CameraRig::Hovering(0);
  const Eigen::Isometry3d still = rig.camera.X_WC(state);
  EXPECT_TRUE(still.isApprox(state.X_WB * rig.vehicle.X_BC()));
  state.vibration_m_s2_B = Eigen::Vector3d(0.5, 0.0, 9.0);
  const Eigen::Isometry3d shaken = rig.camera.X_WC(state);
  EXPECT_EQ(shaken.translation(), still.translation());
  const Eigen::Vector3d rotation_B = models::RotationLog(shaken.linear() * still.linear().transpose());
  EXPECT_TRUE(rotation_B.isApprox(Eigen::Vector3d(0.0, 0.001, 0.0), 1e-6)) << rotation_B.transpose();
}

TEST(Camera, DeliversTheSameFramesForTheSameSeed) {
  CameraRig first, again, other(SmallAndRigid(), 2);
  const auto a = first.Run(60, CameraRig::Hovering), b = again.Run(60, CameraRig::Hovering),
             c = other.Run(60, CameraRig::Hovering);
  ASSERT_EQ(a.size(), 2u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].frame.image.pixels, b[i].frame.image.pixels);
    EXPECT_NE(a[i].frame.image.pixels, c[i].frame.image.pixels);
  }
  EXPECT_NE(a[0].frame.image.pixels, a[1].frame.image.pixels);
}

TEST(Camera, ThrowsForASkippedTick) {
  CameraRig rig;
  rig.camera.Sample(CameraRig::Hovering(0));
  EXPECT_THROW(rig.camera.Sample(CameraRig::Hovering(2)), std::logic_error);
}

TEST(CameraConfig, RejectsInvalidValues) {
  const auto expect_rejected = [](auto change) {
    CameraConfig config;
    change(config);
    EXPECT_THROW(config.Validate(kTime), InputError);
  };
  EXPECT_NO_THROW(CameraConfig{}.Validate(kTime));
  expect_rejected([](CameraConfig& c) { c.model.width_px = 0; });
  expect_rejected([](CameraConfig& c) { c.rate_hz = 7000; });
  expect_rejected([](CameraConfig& c) { c.rate_hz = 0; });
  expect_rejected([](CameraConfig& c) { c.noise_sigma = -1.0; });
  expect_rejected([](CameraConfig& c) { c.noise_sigma = std::numeric_limits<double>::quiet_NaN(); });
  expect_rejected([](CameraConfig& c) { c.exposure_ms = 20.0; });
  expect_rejected([](CameraConfig& c) { c.latency_ms = 1.0; });
  expect_rejected([](CameraConfig& c) { c.latency_ms = std::numeric_limits<double>::infinity(); });
  expect_rejected([](CameraConfig& c) { c.noise_sigma = 24.5; });
  expect_rejected([](CameraConfig& c) { c.vibration_rad_s2_m = -0.1; });
  expect_rejected([](CameraConfig& c) { c.vibration_rad_s2_m = 0.06; });
}

}  // namespace
}  // namespace touchdown::sim
