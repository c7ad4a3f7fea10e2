#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::tests {

/// A sheet's height over the table, bent about parallel lines only, as paper does: flattened from a roll, waved, lifted
/// on a side, or creased. Points are of W; within, lengths are in the ring's radius.
class PhotoPaper {
 public:
  /// `severity` scales the bend, whose kind, heading and size are drawn; 0 is flat.
  PhotoPaper(double radius_m, double severity, models::RandomStream& random);

  double Height(const Eigen::Vector2d& p_W) const;
  Eigen::Vector3d Normal(const Eigen::Vector2d& p_W) const;
  /// The sheet's own coordinates of the paper above a point of the table.
  Eigen::Vector2d SheetPoint(const Eigen::Vector2d& p_W) const;
  /// Within the ring, over the ring's radius.
  double LargestHeight() const;

 private:
  double Along(const Eigen::Vector2d& p_W) const;
  double Raw(double q) const;
  double HeightAt(double q) const;
  double Slope(double q) const;

  double radius_m_, amount_ = 0.0, phase_ = 0.0, period_ = 1.0, begin_ = 0.0;
  int kind_ = 4;
  Eigen::Vector2d across_;
  std::vector<double> lengths_;  ///< Along the paper, to each of its steps.
};

}  // namespace touchdown::tests
