#include "estimator/pad/template_residual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "models/angles.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A pad 0.8 m in front of the camera, tilted by `tilt` about X and rotated by `rotation` in its plane.
struct TiltedPad {
  explicit TiltedPad(double tilt, double rotation = 0.4) {
    const Eigen::Matrix3d facing = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
    R_CW = models::RotationExp({tilt, 0.0, 0.0}) * facing * models::RotationExp({0.0, 0.0, rotation});
    pose.n_C = R_CW.col(2);
    pose.p_CW = {0.05, -0.03, 0.8};
  }
  Vector2d Project(double x, double y) const { return (R_CW * Vector3d(x, y, 0.0) + pose.p_CW).hnormalized(); }

  std::vector<Vector2d> InnerEdge() const {
    std::vector<Vector2d> points;
    for (int i = 0; i < 120; ++i) {
      const double t = models::kPi * i / 60.0;
      points.push_back(Project(pad.inner_radius_m() * std::cos(t), pad.inner_radius_m() * std::sin(t)));
    }
    return points;
  }
  std::vector<Vector2d> Letter() const {
    std::vector<Vector2d> points;
    const double x = 0.5 * pad.h_height_m, y = 0.5 * pad.h_width_m, inner_y = y - pad.h_stroke_m;
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i <= 40; ++i) points.push_back(Project(x * (i / 20.0 - 1.0), side * y));
      for (int i = 0; i <= 8; ++i) points.push_back(Project(x, side * (inner_y + i / 8.0 * pad.h_stroke_m)));
      for (int i = 0; i <= 8; ++i) points.push_back(Project(-x, side * (inner_y + i / 8.0 * pad.h_stroke_m)));
    }
    return points;
  }

  models::LandingPad pad;
  Eigen::Matrix3d R_CW;
  CirclePose pose;
};

TEST(TemplateResidual, IsZeroAtTheTruePose) {
  for (const double rotation : {0.0, 0.4, 1.5, 3.0}) {
    const TiltedPad pad_view(0.5, rotation);
    const TemplateResidual residual =
        ResidualOfTemplate(pad_view.InnerEdge(), pad_view.Letter(), pad_view.pad, pad_view.pose);
    EXPECT_LT(residual.rms_m, 2e-5) << rotation;
    EXPECT_EQ(residual.points, pad_view.InnerEdge().size() + pad_view.Letter().size());
  }
}

TEST(TemplateResidual, IsLargerAtTheOppositeTilt) {
  const TiltedPad pad_view(0.5), mirrored(-0.5);
  EXPECT_GT(ResidualOfTemplate(pad_view.InnerEdge(), pad_view.Letter(), pad_view.pad, mirrored.pose).rms_m, 5e-4);
}

TEST(TemplateResidual, EqualsTheOffsetOfTheArtwork) {
  const TiltedPad pad_view(0.0);
  std::vector<Vector2d> wider = pad_view.InnerEdge();
  for (Vector2d& point : wider) point += 0.002 / 0.8 * (point - pad_view.Project(0.0, 0.0)).normalized();
  EXPECT_NEAR(ResidualOfTemplate(wider, {}, pad_view.pad, pad_view.pose).rms_m, 0.002, 1e-5);
}

TEST(TemplateResidual, LimitsDistancesToHalfAStroke) {
  const TiltedPad pad_view(0.0);
  const std::vector<Vector2d> stray{pad_view.Project(0.0, 0.0)};
  EXPECT_NEAR(ResidualOfTemplate(stray, {}, pad_view.pad, pad_view.pose).rms_m, 0.5 * pad_view.pad.h_stroke_m, 1e-12);
  EXPECT_EQ(ResidualOfTemplate({}, {}, pad_view.pad, pad_view.pose).points, 0u);
}

TEST(WrongBranchProbability, DecreasesWithTheRatioOfTheResiduals) {
  EXPECT_DOUBLE_EQ(WrongBranchProbability({0.001, 300}, {0.001, 300}), 0.5);
  EXPECT_DOUBLE_EQ(WrongBranchProbability({}, {}), 0.5);
  // Ten independent points with twice the sigma: (1/2)^10 against 1.
  EXPECT_NEAR(WrongBranchProbability({0.001, 300}, {0.002, 300}), 1.0 / 1025.0, 1e-12);
  EXPECT_GT(WrongBranchProbability({0.001, 300}, {0.0011, 300}), 0.2);
}

}  // namespace
}  // namespace touchdown::estimator::pad
