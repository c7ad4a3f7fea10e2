#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace touchdown::experiments {

/// Methods that estimate the yaw of the camera from the letter of the pad (Sec. IV-C.3).
enum class YawMethod {
  kEllipseOfHInteger,   ///< Major axis of the ellipse fitted to the contour of the H, integer points.
  kEllipseOfHSubpixel,  ///< As above, with sub-pixel points. Both are the estimator's contours.
  kMomentsOfHBinary,    ///< Central second moments of the pixels that are more than half black.
  kMomentsOfHGray,      ///< Central second moments of all pixels, weighted by darkness.
  kEllipseOfRectangleInteger,
  kEllipseOfRectangleSubpixel,
};

inline constexpr std::array<std::string_view, 6> kYawMethodNames = {
    "ellipse_of_h_integer", "ellipse_of_h_subpixel",        "moments_of_h_binary",
    "moments_of_h_grey",    "ellipse_of_rectangle_integer", "ellipse_of_rectangle_subpixel"};

/// Errors of all methods at one yaw.
struct YawErrors {
  int yaw_deg = 0;  ///< Yaw of the camera, counterclockwise from W's X axis.
  std::array<double, kYawMethodNames.size()>
      error_deg{};  ///< In (-90, 90], because an H has a 180-degree yaw ambiguity.

  double Of(YawMethod method) const { return error_deg[static_cast<std::size_t>(method)]; }
};

/// The experiment of Sec. IV-C.3 on synthetic images without noise. A camera with the default focal length looks
/// straight down from `height_m` above the center of the built-in pad, and of a pad with a solid rectangle of the size
/// of the H. It rotates over 360 degrees in steps of one degree. At 0.32 m the H is 100 px high. Throws InputError when
/// the height is not in [0.1, 2] m, the range in which the letter is a separate component.
std::vector<YawErrors> StudyYaw(double height_m = 0.32);

/// Size of the errors of a method.
struct ErrorSummary {
  double largest_deg = 0.0;  ///< Largest absolute error.
  double rms_deg = 0.0;
};

/// Largest and RMS error of a method over `rows`; 0 without rows.
ErrorSummary SummarizeErrors(std::span<const YawErrors> rows, YawMethod method);

}  // namespace touchdown::experiments
