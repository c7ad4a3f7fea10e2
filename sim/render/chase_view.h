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

/// The room in color with the vehicle in it, from a camera that follows it: for the eyes of people, no sensor. It has
/// a model and a GL context of its own, so that a flight beside it goes as it would without.
class ChaseView {
 public:
  /// Of a World's model, its textures painted, and the vehicle in it. What it sees is 480x480.
  ChaseView(const mjModel_& model, const models::Vehicle& vehicle);
  ~ChaseView();
  ChaseView(const ChaseView&) = delete;
  ChaseView& operator=(const ChaseView&) = delete;

  /// Image of the vehicle at X_WB over the pad, bare or covered, in blue, green, red. Its shadow shows where the
  /// vehicle is above, or without a sun a dark disc on the floor straight below each rotor. The picture is valid until
  /// the next call.
  const cv::Mat3b& Render(const Eigen::Isometry3d& X_WB, bool pad_is_covered);

  /// Where the camera of the newest picture is, frame C. It looks forward and down, from behind, at the middle between
  /// pad and vehicle, from so far that both are in the view whole. It stands still until the vehicle has moved by a
  /// step's length, and then follows as if on a leash: as smoothly as the vehicle, and a hover leaves the room at rest.
  const Eigen::Isometry3d& X_WC() const { return X_WC_; }
  const PinholeView& view() const { return view_; }

 private:
  struct Impl;

  void Follow(const Eigen::Vector3d& p_WB);
  void AddDiscsBelow(const Eigen::Isometry3d& X_WB);

  models::Vehicle vehicle_;
  PinholeView view_;
  std::optional<Eigen::Vector3d> followed_;  ///< A place within the leash's length of the vehicle.
  Eigen::Isometry3d X_WC_ = Eigen::Isometry3d::Identity();
  cv::Mat3b picture_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sim
