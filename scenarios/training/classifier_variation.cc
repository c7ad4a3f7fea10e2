#include "scenarios/training/classifier_variation.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "estimator/paper/classifier.h"

namespace touchdown::training {
namespace {

using models::RandomStream;

constexpr double kMaxShear = 0.2;
constexpr double kMaxKeystone = 0.15;
constexpr int kSide = estimator::paper::kPatternSide;
constexpr int kOversampling = 2;  ///< Samples along each side of a cell.

cv::Mat1f RandomSymmetry(const cv::Mat1f& pattern, RandomStream& random) {
  const int symmetry = random.UniformInt(0, 7);
  cv::Mat1f transformed = pattern.clone();
  if ((symmetry & 1) != 0) cv::flip(transformed, transformed, 0);
  if ((symmetry & 2) != 0) cv::flip(transformed, transformed, 1);
  if ((symmetry & 4) != 0) cv::transpose(transformed, transformed);
  return transformed;
}

/// Random homography in coordinates from -1 to 1 over the pattern.
cv::Matx33d DrawHomography(RandomStream& random) {
  const double shear_x = kMaxShear * random.Uniform(-1.0, 1.0), shear_y = kMaxShear * random.Uniform(-1.0, 1.0);
  const double tilt_x = kMaxKeystone * random.Uniform(-1.0, 1.0);
  const double tilt_y = kMaxKeystone * random.Uniform(-1.0, 1.0);
  return {1.0, shear_x, 0.0, shear_y, 1.0, 0.0, tilt_x, tilt_y, 1.0};
}

/// Transform from cell coordinates (centers at integers) to coordinates from -1 to 1.
cv::Matx33d Normalized(int side) {
  return {2.0 / side, 0.0, 1.0 / side - 1.0, 0.0, 2.0 / side, 1.0 / side - 1.0, 0.0, 0.0, 1.0};
}

/// Images of the corners of all cells with ink.
std::vector<cv::Point2d> WarpedInkCorners(const cv::Matx33d& homography, const cv::Mat1f& pattern) {
  std::vector<cv::Point> cells;
  cv::findNonZero(pattern > 0.0f, cells);
  if (cells.empty()) return {};
  std::vector<cv::Point2d> corners, moved;
  for (const cv::Point& cell : cells) {
    for (const double dx : {-0.5, 0.5}) {
      for (const double dy : {-0.5, 0.5}) corners.emplace_back(cell.x + dx, cell.y + dy);
    }
  }
  cv::perspectiveTransform(corners, moved, homography);
  return moved;
}

cv::Mat1f Warped(const cv::Matx33d& homography, const cv::Mat1f& pattern) {
  const cv::Matx33d from_cells = homography * Normalized(kSide);
  const std::vector<cv::Point2d> ink = WarpedInkCorners(from_cells, pattern);
  if (ink.empty()) return pattern;
  const auto [left, right] =
      std::minmax_element(ink.begin(), ink.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] =
      std::minmax_element(ink.begin(), ink.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  constexpr int kOversampledSide = kOversampling * kSide;
  const double scale_x = kOversampledSide / (right->x - left->x), scale_y = kOversampledSide / (bottom->y - top->y);
  const cv::Matx33d to_box(scale_x, 0.0, -scale_x * left->x - 0.5, 0.0, scale_y, -scale_y * top->y - 0.5, 0.0, 0.0,
                           1.0);
  cv::Mat1f fine, cells;
  cv::warpPerspective(pattern, fine, to_box * from_cells, {kOversampledSide, kOversampledSide}, cv::INTER_LINEAR);
  cv::resize(fine, cells, {kSide, kSide}, 0, 0, cv::INTER_AREA);
  return cells;
}

}  // namespace

std::vector<float> VaryPattern(const std::vector<float>& pattern, RandomStream& random) {
  const cv::Mat1f transformed = RandomSymmetry(cv::Mat1f(pattern).reshape(1, kSide), random);
  const cv::Mat1f varied = random.Bernoulli(0.5) ? Warped(DrawHomography(random), transformed) : transformed;
  return {varied.begin(), varied.end()};
}

}  // namespace touchdown::training
