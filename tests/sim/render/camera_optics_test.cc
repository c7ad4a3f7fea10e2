#include "sim/render/camera_optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/error.h"
#include "tests/support/rooms.h"

namespace touchdown::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using tests::CameraAt;
using tests::CameraTowards;
using tests::EdgeOffset;
using tests::EmptyRoomConfig;
using tests::Room;

models::Image Rounded(const FineImage& fine) {
  models::Image image(fine.width, fine.height);
  std::transform(fine.pixels.begin(), fine.pixels.end(), image.pixels.begin(),
                 [](std::uint16_t level) { return static_cast<std::uint8_t>((level + 128) >> 8); });
  return image;
}

/// Difference of two frames in gray levels.
struct Difference {
  double rms = 0.0;
  double worst = 0.0;
};

Difference Between(const std::vector<double>& expected, const FineImage& actual) {
  Difference difference;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double error = actual.pixels[i] / 256.0 - expected[i];
    difference.rms += error * error / static_cast<double>(expected.size());
    difference.worst = std::max(difference.worst, std::abs(error));
  }
  difference.rms = std::sqrt(difference.rms);
  return difference;
}

/// Reference exposure: the mean of frames rendered at 48 poses along the path, more than CameraOptics averages.
std::vector<double> ReferenceExposure(CameraOptics& optics, Renderer& renderer, mjData_& data, ExposurePath X_WC) {
  constexpr int kViews = 48;
  std::vector<double> mean;
  for (int i = 0; i < kViews; ++i) {
    const Isometry3d pose = PoseAlong(X_WC, (i + 0.5) / kViews);
    const FineImage view = optics.Expose(renderer.Render(data, pose), std::vector{pose});
    mean.resize(view.pixels.size(), 0.0);
    for (std::size_t j = 0; j < mean.size(); ++j) mean[j] += view.pixels[j] / 256.0 / kViews;
  }
  return mean;
}

FineImage Exposed(CameraOptics& optics, Renderer& renderer, mjData_& data, ExposurePath X_WC) {
  return optics.Expose(renderer.Render(data, PoseAlong(X_WC, 0.5)), X_WC);
}

TEST(CameraOptics, RendersThePadsEdgesAtTheirDistortedPixels) {
  const Room room(EmptyRoomConfig());
  const models::CameraModel wide;
  const models::CameraModel euroc{.k1 = -0.283, .k2 = 0.074};
  const models::CameraModel uneven{.fx_px = 330.0, .fy_px = 300.0, .cx_px = 300.25, .cy_px = 250.75, .k1 = -0.05};
  for (const models::CameraModel& camera : {wide, euroc, uneven}) {
    CameraOptics optics(camera);
    Renderer renderer(*room.model, optics.pinhole_view());
    for (const Isometry3d& X_WC : {CameraAt({0.02, 0.01, 0.3}), CameraTowards({0.2, 0.1, 0.3}, {0.15, 0.1}, 0.4),
                                   CameraTowards({-0.1, -0.2, 0.25}, {-0.1, 0.1}, 2.0)}) {
      const models::Image image = Rounded(Exposed(optics, renderer, *room.data, std::vector{X_WC}));
      const auto pixel_of = [&](const Vector3d& p_W) { return camera.Project(X_WC.inverse() * p_W).value(); };
      int count = 0;
      double sum = 0.0, sum_of_squares = 0.0;
      for (int i = 0; i < 72; ++i) {
        const Vector3d outward(std::cos(i * models::kPi / 36), std::sin(i * models::kPi / 36), 0.0);
        const Vector2d edge = pixel_of(room.scene.pad.outer_radius_m * outward);
        if (!camera.Contains(edge + Vector2d::Constant(6.0)) || !camera.Contains(edge - Vector2d::Constant(6.0)))
          continue;
        const Vector2d next = pixel_of((room.scene.pad.outer_radius_m + 1e-4) * outward);
        const double offset = EdgeOffset(image, edge, (next - edge).normalized());
        EXPECT_LT(std::abs(offset), 0.15) << edge.transpose();
        sum += offset;
        sum_of_squares += offset * offset;
        ++count;
      }
      EXPECT_GE(count, 40);
      EXPECT_LT(std::sqrt(sum_of_squares / count), 0.05);
      EXPECT_LT(std::abs(sum / count), 0.02);
    }
  }
}

TEST(CameraOptics, DoesNotChangeAnUndistortedView) {
  const Room room({}, 2);
  CameraOptics optics({.k1 = 0.0, .k2 = 0.0});
  Renderer wide(*room.model, optics.pinhole_view());
  Renderer plain(*room.model, {});
  const Isometry3d X_WC = CameraAt({0.1, 0.0, 0.8}, {.roll = 0.1, .pitch = 0.0, .yaw = 0.2});
  const FineImage frame = Exposed(optics, wide, *room.data, std::vector{X_WC});
  const models::Image& pinhole = plain.Render(*room.data, X_WC);
  std::size_t different = 0;
  for (std::size_t i = 0; i < pinhole.pixels.size(); ++i) {
    EXPECT_EQ(frame.pixels[i] % 256, 0);
    different += std::abs(frame.pixels[i] / 256 - pinhole.pixels[i]) > 2 ? 1 : 0;
  }
  EXPECT_LT(different, pinhole.pixels.size() / 500);
}

TEST(CameraOptics, BlursTheFloorAsTheMeanOfViewsAlongThePath) {
  const Room room({.objects = 0}, 4);
  CameraOptics optics(models::CameraModel{});
  Renderer renderer(*room.model, optics.pinhole_view());
  const std::vector<std::vector<Isometry3d>> paths{
      {CameraAt({0.0, 0.0, 0.6}), CameraAt({0.006, 0.0, 0.6})},
      {CameraAt({0.1, 0.1, 0.8}, {0.1, -0.1, 0.2}), CameraAt({0.102, 0.104, 0.804}, {0.104, -0.106, 0.204})},
      {CameraAt({0, 0, 1.0}, {0.0, 0.0, 0.0}), CameraAt({0, 0, 1.0}, {0.003, 0.0, 0.0}),
       CameraAt({0, 0, 1.0}, {0, 0.003, 0})},
  };
  for (const auto& path : paths) {
    const std::vector<double> truth = ReferenceExposure(optics, renderer, *room.data, path);
    const Difference warped = Between(truth, Exposed(optics, renderer, *room.data, path));
    const Difference unblurred =
        Between(truth, Exposed(optics, renderer, *room.data, std::vector{PoseAlong(path, 0.5)}));
    EXPECT_LT(warped.rms, 2.0);
    EXPECT_LT(warped.rms, 0.5 * unblurred.rms);
  }
}

TEST(CameraOptics, BlursSolidItemsLikeTheFloor) {
  const Room room({.posters = 0, .lone_circles = 0, .lone_letters = 0, .objects = 30}, 4);
  CameraOptics optics(models::CameraModel{});
  Renderer renderer(*room.model, optics.pinhole_view());
  const Vector3d above(1.0, 0.0, 1.0);
  const std::vector slide{CameraAt(above), CameraAt(above + Vector3d(0.02, 0.0, 0.0))};
  const std::vector turn{CameraAt(above), CameraAt(above, {.roll = 0.02, .pitch = 0.0, .yaw = 0.0})};
  const auto error_of = [&](const std::vector<Isometry3d>& path) {
    const std::vector<double> truth = ReferenceExposure(optics, renderer, *room.data, path);
    return Between(truth, Exposed(optics, renderer, *room.data, path)).rms;
  };
  EXPECT_LT(error_of(turn), 1.0);
  EXPECT_LT(error_of(slide), 1.5);
  RecordProperty("rms_turn", std::to_string(error_of(turn)));
  RecordProperty("rms_slide", std::to_string(error_of(slide)));
}

TEST(CameraOptics, UsesMoreTapsForFasterMotion) {
  CameraOptics optics(models::CameraModel{});
  const auto taps_for = [&](double roll) {
    return optics.TapsFor(std::vector{CameraAt({0, 0, 1}), CameraAt({0, 0, 1}, {.roll = roll, .pitch = 0, .yaw = 0})});
  };
  EXPECT_EQ(optics.TapsFor(std::vector{CameraAt({0, 0, 1})}), 1);
  EXPECT_EQ(taps_for(0.0), 1);
  EXPECT_EQ(taps_for(0.0001), 1);
  EXPECT_EQ(taps_for(0.001), 2);
  EXPECT_GT(taps_for(0.01), 6);
  EXPECT_LE(taps_for(0.01), 14);
  EXPECT_EQ(taps_for(1.0), CameraOptics::kMaxTaps);
}

TEST(CameraOptics, CountsBackAndForthMotion) {
  CameraOptics optics(models::CameraModel{});
  const Isometry3d still = CameraAt({0, 0, 1}), aside = CameraAt({0, 0, 1}, {.roll = 0.005, .pitch = 0, .yaw = 0});
  EXPECT_GT(optics.TapsFor(std::vector{still, aside, still}), 3);
}

TEST(CameraOptics, BlursAboveTheHorizonByRotationAlone) {
  CameraOptics optics(models::CameraModel{});
  const PinholeView& view = optics.pinhole_view();
  models::Image half(view.width_px, view.height_px, 0);
  for (int v = 0; v < view.height_px; ++v) std::fill_n(half.Row(v) + view.width_px / 2, view.width_px / 2, 200);
  const models::TaitBryan level{.roll = 0.0, .pitch = -1.5, .yaw = 0.0};
  const std::vector slide{CameraAt({0, 0, 1}, level), CameraAt({0, 0.05, 1}, level)};
  const FineImage frame = optics.Expose(half, slide);
  const FineImage still = optics.Expose(half, std::vector{PoseAlong(slide, 0.5)});
  const auto row_difference = [&](int v) {
    int most = 0;
    for (int u = 0; u < 640; ++u) {
      const std::size_t i = static_cast<std::size_t>(v * 640 + u);
      most = std::max(most, std::abs(frame.pixels[i] - still.pixels[i]));
    }
    return most;
  };
  EXPECT_LT(row_difference(10), 256 * 8);
  EXPECT_GT(row_difference(470), 256 * 20);
}

TEST(PoseAlong, InterpolatesBetweenNeighbors) {
  const std::vector path{CameraAt({0, 0, 1}), CameraAt({0, 0, 2}, {0.2, 0, 0}), CameraAt({1, 0, 2}, {0.2, 0, 0})};
  EXPECT_TRUE(PoseAlong(path, 0.0).isApprox(path[0]));
  EXPECT_TRUE(PoseAlong(path, 0.25).isApprox(CameraAt({0, 0, 1.5}, {0.1, 0, 0})));
  EXPECT_TRUE(PoseAlong(path, 0.5).isApprox(path[1]));
  EXPECT_TRUE(PoseAlong(path, 0.75).isApprox(CameraAt({0.5, 0, 2}, {0.2, 0, 0})));
  EXPECT_TRUE(PoseAlong(path, 1.0).isApprox(path[2]));
}

TEST(CameraOptics, RejectsALensThatNeedsTooWideAView) {
  EXPECT_THROW(CameraOptics({.width_px = 0}), InputError);
  EXPECT_THROW(CameraOptics({.width_px = 8000, .height_px = 100, .cx_px = 4000, .k1 = 0.0, .k2 = 0.0}), InputError);
}

}  // namespace
}  // namespace touchdown::sim
