#pragma once

#include <Eigen/Core>
#include <optional>

#include "models/describe.h"

namespace touchdown::models {

/// A pinhole camera with radial and tangential distortion (ROS `plumb_bob`; Brown 1966). The paper uses the first two
/// radial terms (Sec. IV-B).
///
/// Frame C: X right, Y down, Z forward, origin at the optical center. Pixel centers lie on integer coordinates,
/// so the image covers [-0.5, width - 0.5] x [-0.5, height - 0.5]. "Normalized" points are (x/z, y/z) in C.
struct CameraModel {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 320.0;  // Horizontal field of view of 90 degrees at 640 px.
  double fy_px = 320.0;
  double cx_px = 319.5;
  double cy_px = 239.5;
  double k1 = -0.10;
  double k2 = 0.01;
  double p1 = 0.0;
  double p2 = 0.0;
  double k3 = 0.0;

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the distortion is
  /// not invertible within the image.
  void Validate() const;

  /// Distorts an ideal normalized point: x (1 + k1 r^2 + k2 r^4 + k3 r^6), plus the tangential terms
  /// (2 p1 x y + p2 (r^2 + 2 x^2), p1 (r^2 + 2 y^2) + 2 p2 x y).
  Eigen::Vector2d Distort(const Eigen::Vector2d& ideal) const;

  /// Inverse of Distort, by Newton's method: first on the radius (Sec. IV-B), then, if there are tangential terms, on
  /// the point. Returns nullopt if no ideal point maps to `distorted`, which does not happen within the image of a
  /// valid camera.
  std::optional<Eigen::Vector2d> Undistort(const Eigen::Vector2d& distorted) const;

  /// Ideal radius up to which the radial part of Distort is monotonic, and therefore invertible; infinity when it is
  /// monotonic everywhere.
  double MonotonicRadius() const;

  Eigen::Vector2d PixelFromNormalized(const Eigen::Vector2d& distorted) const;
  Eigen::Vector2d NormalizedFromPixel(const Eigen::Vector2d& pixel) const;

  /// Raw (distorted) pixel of a point given in C. Returns nullopt if the point is behind the camera or beyond
  /// MonotonicRadius. The pixel may be outside the image, see Contains.
  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p_C) const;

  /// Unit ray in C through a raw pixel. Returns nullopt where Undistort does.
  std::optional<Eigen::Vector3d> Ray(const Eigen::Vector2d& pixel) const;

  bool Contains(const Eigen::Vector2d& pixel) const;

  friend bool operator==(const CameraModel&, const CameraModel&) = default;

 private:
  bool HasTangentialTerms() const { return p1 != 0.0 || p2 != 0.0; }
  Eigen::Matrix2d DistortJacobian(const Eigen::Vector2d& ideal) const;
  std::optional<Eigen::Vector2d> UndistortRadial(const Eigen::Vector2d& distorted) const;
};

inline constexpr Range kImageSize_px = Between(1, 16384);
/// The keys of a camera model may be in a file of their own, also in ROS `camera_info` format.
inline constexpr SectionFile kCameraModelFile{.allowed = true, .format = "camera_info"};

void Describe(ConfigVisitor& v, CameraModel& camera);

}  // namespace touchdown::models
