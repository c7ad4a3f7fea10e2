#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "models/camera_model.h"
#include "models/signals.h"
#include "sim/render/packed_image.h"
#include "sim/render/renderer.h"

namespace touchdown::sim {

/// Poses of the camera at equal time steps from the opening of the shutter to its closing, both included. A single pose
/// is a camera at rest.
using ExposurePath = std::span<const Eigen::Isometry3d>;

/// Pose at `fraction` (0 to 1) of the exposure, interpolated between its neighbors; 0.5 is mid-exposure.
Eigen::Isometry3d PoseAlong(ExposurePath X_WC, double fraction);

/// Model of lens and shutter: converts one wide pinhole view at mid-exposure into the image on the sensor, in a single
/// pass of bilinear lookups.
///
/// The lens distortion is exact. An exposure during which the camera moves is the mean of up to kMaxTaps views
/// along its path, each of which is the mid-exposure view warped by the homography that the floor (the plane z = 0 of
/// W) induces between the two poses. This is exact for points on the floor. A point at height h below a camera at
/// height H is blurred like the floor: under translation its streak has (H - h) / H of the true length; under rotation
/// the blur is exact. Changes of occlusion within an exposure are not modeled.
class CameraOptics {
 public:
  static constexpr int kMaxTaps = 32;

  /// Throws InputError when the camera is not valid or its lens needs a pinhole view of more than 4096 px.
  explicit CameraOptics(const models::CameraModel& camera);

  /// Pinhole view to render: the pixel grid of the frame, extended for the lens distortion and a little blur.
  const PinholeView& pinhole_view() const { return view_; }

  /// Exposes a frame. `pinhole` is the image of pinhole_view() rendered from PoseAlong(X_WC, 0.5). Where the blur
  /// reaches beyond the rendered view, the view's border is repeated. The frame is valid until the next call.
  const FineImage& Expose(const models::Image& pinhole, ExposurePath X_WC);

  /// Number of views that are averaged: 1 if no pixel moves by more than 0.25 px, else the number at which consecutive
  /// views are at most 1 px apart, from 2 to kMaxTaps.
  int TapsFor(ExposurePath X_WC) const;

 private:
  using Vector2i = Eigen::Matrix<std::int32_t, 2, 1>;
  /// Shifts in the pinhole view at the nodes of a coarse grid over the frame, in 1/65536 px.
  using ShiftGrid = std::vector<Vector2i>;

  void MakeLookups(const models::CameraModel& camera);
  Eigen::Vector2d LookupOf(int u, int v) const;
  int NodeColumn(int i) const;
  int NodeRow(int j) const;
  Eigen::Vector2d ShiftAt(const Eigen::Vector2d& pixel, const Eigen::Isometry3d& X_WM,
                          const Eigen::Isometry3d& X_WS) const;
  ShiftGrid ShiftsBetween(const Eigen::Isometry3d& X_WM, const Eigen::Isometry3d& X_WS) const;
  void AddRow(const ShiftGrid& shifts, int v, std::uint32_t* sums) const;

  int width_;
  int height_;
  PinholeView view_;
  int grid_columns_;
  int grid_rows_;
  /// Position of each pixel of the frame in the pinhole view, in 1/65536 px.
  std::vector<std::int32_t> lookups_x_, lookups_y_;
  PackedImage pinhole_;
  FineImage frame_;
};

}  // namespace touchdown::sim
