#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "models/vehicle.h"
#include "sim/render/pinhole_view.h"

struct mjModel_;

namespace touchdown::sim {

/// Color view of the scene and the vehicle from a camera that follows the vehicle, for videos. It is not a sensor: its
/// own model and GL context keep it from affecting the flight.
class ChaseView {
 public:
  /// `model` is the model of a World with painted textures. Images have 480 x 480 px.
  ChaseView(const mjModel_& model, const models::Vehicle& vehicle);
  ~ChaseView();
  ChaseView(const ChaseView&) = delete;
  ChaseView& operator=(const ChaseView&) = delete;

  /// Renders the vehicle at X_WB over the bare or covered pad, in blue, green, red. The image shows the vehicle's
  /// shadow or, without a sun, a dark disc on the floor straight below each rotor. The image is valid until the next
  /// call.
  const cv::Mat3b& Render(const Eigen::Isometry3d& X_WB, bool pad_is_covered);

  /// Pose of the camera (frame C) of the newest image. It looks forward and down, from behind, at the midpoint of pad
  /// and vehicle, from a distance at which both are in view. It does not move while the vehicle stays
  /// within a dead band, so that the background is at rest in a hover.
  const Eigen::Isometry3d& X_WC() const { return X_WC_; }
  const PinholeView& view() const { return view_; }

 private:
  struct Impl;

  void Follow(const Eigen::Vector3d& p_WB);
  void AddDiscsBelow(const Eigen::Isometry3d& X_WB);

  models::Vehicle vehicle_;
  PinholeView view_;
  std::optional<Eigen::Vector3d> followed_;  ///< Position that the camera follows, within the dead band.
  Eigen::Isometry3d X_WC_ = Eigen::Isometry3d::Identity();
  cv::Mat3b image_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sim
