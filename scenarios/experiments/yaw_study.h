#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace touchdown::experiments {

/// The ways to tell how far a camera is turned about its axis from what it sees of a pad's letter (Sec. IV-C.3).
enum class YawMethod {
  kEllipseOfHInteger,   ///< Major axis of the ellipse fitted to the H's contour, of whole pixels ...
  kEllipseOfHSubpixel,  ///< ... and of sub-pixel points, as the estimator finds both.
  kMomentsOfHBinary,    ///< Central second moments of the pixels that are more than half black ...
  kMomentsOfHGrey,      ///< ... and of all by how dark they are.
  kEllipseOfRectangleInteger,
  kEllipseOfRectangleSubpixel,
};

inline constexpr std::array<std::string_view, 6> kYawMethodNames = {
    "ellipse_of_h_integer", "ellipse_of_h_subpixel",        "moments_of_h_binary",
    "moments_of_h_grey",    "ellipse_of_rectangle_integer", "ellipse_of_rectangle_subpixel"};

/// What each method is off by at one yaw.
struct YawErrors {
  int yaw_deg = 0;                                         ///< Of the camera, left, from W's X axis.
  std::array<double, kYawMethodNames.size()> error_deg{};  ///< Within (-90, 90]: an H is the same after half a turn.

  double Of(YawMethod method) const { return error_deg[static_cast<std::size_t>(method)]; }
};

/// The experiment of Sec. IV-C.3 on synthetic images: a camera of the default focal length, without noise, looks
/// straight down from `height_m` over the center of the built-in pad, and of one with a solid rectangle as large as the
/// H, and is turned by one degree after the other over a whole turn. From 0.32 m the H is 100 px high. Throws
/// InputError when the height is not within [0.1, 2] m, where the letter is a component of its own.
std::vector<YawErrors> StudyYaw(double height_m = 0.32);

struct ErrorSize {
  double largest_deg = 0.0;  ///< Of the absolute values.
  double rms_deg = 0.0;
};

/// 0 without rows.
ErrorSize SizeOfErrors(std::span<const YawErrors> rows, YawMethod method);

}  // namespace touchdown::experiments
