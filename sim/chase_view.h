#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "models/vehicle.h"
#include "sim/pinhole_view.h"

struct mjModel_;

namespace touchdown::sim {

/// The room in colour with the vehicle in it, from a camera that follows it: for the eyes of people, no sensor. It has
/// a model and a GL context of its own, so that a flight beside it goes as it would without.
class ChaseView {
 public:
  /// Of a World's model, its textures painted, and the vehicle in it. What it sees is 480x480.
  ChaseView(const mjModel_& model, const models::Vehicle& vehicle);
  ~ChaseView();
  ChaseView(const ChaseView&) = delete;
  ChaseView& operator=(const ChaseView&) = delete;

  /// The vehicle at X_WB over a pad that lies bare or covered, blue, green, red. A dark disc on the floor straight
  /// below each rotor tells where the vehicle is above. The picture is valid until the next call.
  const cv::Mat3b& Render(const Eigen::Isometry3d& X_WB, bool pad_is_covered);

  /// Where the camera is for a vehicle at p_WB, frame C: it looks forward and down, from behind, at the middle between
  /// pad and vehicle, from so far that both are in the view whole. It depends on the place alone, so that it moves as
  /// smoothly as the vehicle.
  Eigen::Isometry3d X_WC(const Eigen::Vector3d& p_WB) const;
  const PinholeView& view() const { return view_; }

 private:
  struct Impl;

  void AddShadow(const Eigen::Isometry3d& X_WB);

  models::Vehicle vehicle_;
  PinholeView view_;
  cv::Mat3b picture_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sim
