#include "tests/support/photograph_score.h"

#include <algorithm>
#include <cmath>

#include "estimator/paper/paper_estimator.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;

/// Bounding box, in raw px, of an ellipse in undistorted px.
cv::Rect2d BoxOf(const estimator::Overlay::Ellipse& ellipse, const models::CameraModel& camera) {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
  for (int i = 0; i < 180; ++i) {
    const double t = 2.0 * M_PI * i / 180.0;
    const Vector2d p =
        ellipse.center + Eigen::Rotation2Dd(ellipse.angle) *
                             Vector2d(ellipse.semi_axes.x() * std::cos(t), ellipse.semi_axes.y() * std::sin(t));
    const Vector2d pixel = camera.PixelFromNormalized(camera.Distort(camera.NormalizedFromPixel(p)));
    low = low.min(pixel.array());
    high = high.max(pixel.array());
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

double Overlap(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double common = (a & b).area();
  return common / (a.area() + b.area() - common);
}

}  // namespace

PhotoScore Score(const Photograph& photo) {
  estimator::EstimatorSetup setup{
      .camera = photo.camera, .pad = photo.pad, .time = {}, .frame_order = estimator::FrameOrder::kUnrelated};
  setup.X_BC = Eigen::Isometry3d::Identity();
  setup.X_BC.linear() = NominalR_BC();
  estimator::paper::PaperEstimator estimator(setup);
  const Eigen::Isometry3d X_WB = photo.X_WC * setup.X_BC.inverse();
  PhotoScore score;
  score.estimate = estimator.Estimate(photo.image.View(), 0, GravityIn(X_WB));
  score.reports_pad = score.estimate.pad_px.has_value();
  const estimator::Overlay::Ellipse* const ring = score.estimate.overlay.FindEllipse("ring_outer");
  if (!score.estimate.pose || ring == nullptr) return score;
  const cv::Rect2d box = BoxOf(*ring, photo.camera);
  const double reach = 0.05 * std::max(photo.ring_box.width, photo.ring_box.height) + 2.0;
  score.found = photo.subject == "pad" && (*score.estimate.pad_px - photo.center_px).norm() < reach &&
                Overlap(box, photo.ring_box) > 0.8;
  const double truth = photo.X_WC.translation().norm();
  score.distance_error = std::abs((score.estimate.pose->X_WB * setup.X_BC).translation().norm() - truth) / truth;
  return score;
}

}  // namespace touchdown::tests
