#include "scenarios/laboratory/calibration_corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "models/error.h"

namespace touchdown::laboratory {
namespace {

cv::Point2f Centroid(const cv::Point2f& a, const cv::Point2f& b, const cv::Point2f& c, const cv::Point2f& d) {
  return (a + b + c + d) / 4.0F;
}

/// Gray level at the center of the square whose first corner has index `first`.
double SquareLevel(const cv::Mat1b& image, const std::vector<cv::Point2f>& corners, int columns, int first) {
  const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  const cv::Point2f center = Centroid(at(first), at(first + 1), at(first + columns), at(first + columns + 1));
  cv::Mat1b patch;
  cv::getRectSubPix(image, {3, 3}, center, patch);
  return cv::mean(patch)[0];
}

/// Half the side of the window for subpixel refinement, px, small enough to contain no other corner.
int RefinementWindow_px(const std::vector<cv::Point2f>& corners, int columns) {
  constexpr double kFraction = 0.35, kMin_px = 2.0, kMax_px = 11.0;
  double nearest_px = kMax_px / kFraction;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if ((i + 1) % static_cast<std::size_t>(columns) != 0) {
      nearest_px = std::min(nearest_px, cv::norm(corners[i + 1] - corners[i]));
    }
    const std::size_t below = i + static_cast<std::size_t>(columns);
    if (below < corners.size()) nearest_px = std::min(nearest_px, cv::norm(corners[below] - corners[i]));
  }
  return static_cast<int>(std::clamp(kFraction * nearest_px, kMin_px, kMax_px));
}

Eigen::Isometry3d PoseOf(const cv::Mat& rotation, const cv::Mat& translation) {
  cv::Matx33d R;
  cv::Rodrigues(rotation, R);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d linear;
  cv::cv2eigen(R, linear);
  X.linear() = linear;
  X.translation() = Eigen::Map<const Eigen::Vector3d>(translation.ptr<double>());
  return X;
}

int FlagsFor(LensTerms terms) { return terms == LensTerms::kAll ? 0 : cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST; }

void RequireViews(std::size_t count) {
  constexpr std::size_t kMinViews = 3;
  if (count >= kMinViews) return;
  throw InputError(fmt::format("calibration pattern detected in {} views; at least {} are required", count, kMinViews));
}

std::vector<ImageCorners> SelectViews(std::span<const ImageCorners> views, const std::vector<std::size_t>& indices) {
  std::vector<ImageCorners> selected;
  for (const std::size_t index : indices) selected.push_back(views[index]);
  return selected;
}

/// Fit to a subset of the views, none excluded.
struct SubsetFit {
  models::CameraModel model;
  std::vector<Eigen::Isometry3d> X_EC;
  std::vector<double> view_rms_px;
  double rms_px = 0.0;
};

SubsetFit FitSubset(const std::vector<ImageCorners>& views, const Chessboard& board, int width_px, int height_px,
                    LensTerms terms) {
  std::vector<cv::Point3f> board_points;
  for (const Eigen::Vector3d& p_E : board.Corners()) {
    board_points.emplace_back(static_cast<float>(p_E.x()), static_cast<float>(p_E.y()), 0.0F);
  }
  std::vector<std::vector<cv::Point2f>> image_points;
  for (const ImageCorners& view : views) {
    auto& points = image_points.emplace_back();
    for (const Eigen::Vector2d& pixel : view) {
      points.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
    }
  }
  cv::Matx33d K = cv::Matx33d::eye();
  cv::Mat1d distortion = cv::Mat1d::zeros(5, 1), view_rms;
  std::vector<cv::Mat> rotations, translations;
  SubsetFit fit;
  fit.rms_px = cv::calibrateCamera(std::vector(views.size(), board_points), image_points, {width_px, height_px}, K,
                                   distortion, rotations, translations, cv::noArray(), cv::noArray(), view_rms,
                                   FlagsFor(terms), {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12});
  const auto term = [&distortion](int i) { return distortion.at<double>(i); };
  fit.model = {.width_px = width_px,
               .height_px = height_px,
               .fx_px = K(0, 0),
               .fy_px = K(1, 1),
               .cx_px = K(0, 2),
               .cy_px = K(1, 2),
               .k1 = term(0),
               .k2 = term(1),
               .p1 = term(2),
               .p2 = term(3),
               .k3 = term(4)};
  for (std::size_t i = 0; i < views.size(); ++i) {
    fit.X_EC.push_back(PoseOf(rotations[i], translations[i]).inverse());
    fit.view_rms_px.push_back(view_rms.at<double>(static_cast<int>(i)));
  }
  return fit;
}

/// Indices of the views whose error is not far above the median; the other views have a misdetected corner.
std::vector<std::size_t> ConsistentViews(const std::vector<double>& rms_px) {
  constexpr double kMaxOverMedian = 4.0, kRounding_px = 0.01;
  std::vector<double> sorted = rms_px;
  std::sort(sorted.begin(), sorted.end());
  const double max_px = kMaxOverMedian * sorted[sorted.size() / 2] + kRounding_px;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < rms_px.size(); ++i) {
    if (rms_px[i] <= max_px) indices.push_back(i);
  }
  return indices;
}

}  // namespace

std::optional<ImageCorners> FindCorners(const models::ImageView& image, const Chessboard& board) {
  const cv::Mat1b mat(image.height, image.width, const_cast<std::uint8_t*>(image.data),
                      static_cast<std::size_t>(image.stride));
  const cv::Size count = board.corner_count();
  // Smoothing keeps the detector from treating noise as squares. Refinement uses the original image.
  constexpr double kSmoothing_px = 1.0;
  cv::Mat1b smooth;
  cv::GaussianBlur(mat, smooth, {}, kSmoothing_px);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(smooth, count, corners)) return std::nullopt;
  const int last_square = static_cast<int>(corners.size()) - count.width - 2;
  if (SquareLevel(mat, corners, count.width, 0) > SquareLevel(mat, corners, count.width, last_square)) {
    std::reverse(corners.begin(), corners.end());
  }
  const int window_px = RefinementWindow_px(corners, count.width);
  cv::cornerSubPix(mat, corners, {window_px, window_px}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
  ImageCorners result;
  for (const cv::Point2f& corner : corners) result.emplace_back(corner.x, corner.y);
  return result;
}

CameraFit FitCamera(std::span<const ImageCorners> views, const Chessboard& board, int width_px, int height_px,
                    LensTerms terms) {
  std::vector<std::size_t> used(views.size());
  std::iota(used.begin(), used.end(), std::size_t{0});
  for (;;) {
    RequireViews(used.size());
    const SubsetFit subset_fit = FitSubset(SelectViews(views, used), board, width_px, height_px, terms);
    std::vector<std::size_t> kept;
    for (const std::size_t index : ConsistentViews(subset_fit.view_rms_px)) kept.push_back(used[index]);
    if (kept.size() < used.size()) {
      used = std::move(kept);
      continue;
    }
    CameraFit fit{.model = subset_fit.model, .X_EC = std::vector<std::optional<Eigen::Isometry3d>>(views.size())};
    fit.rms_px = subset_fit.rms_px;
    for (std::size_t i = 0; i < used.size(); ++i) fit.X_EC[used[i]] = subset_fit.X_EC[i];
    fit.model.Validate();
    return fit;
  }
}

}  // namespace touchdown::laboratory
