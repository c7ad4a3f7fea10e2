#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/random_stream.h"

namespace touchdown::tests {

/// Shape of a sheet of paper on a table. It bends about parallel lines only: it is curled, wavy, lifted at a side or
/// creased. Points are in W. Private lengths are relative to the radius of the ring.
class PhotoPaper {
 public:
  /// Draws kind, direction and size of the bend. `severity` scales it; 0 is flat.
  PhotoPaper(double radius_m, double severity, models::RandomStream& random);

  double Height(const Eigen::Vector2d& p_W) const;
  Eigen::Vector3d Normal(const Eigen::Vector2d& p_W) const;
  /// Coordinates on the sheet of the paper above a point of the table.
  Eigen::Vector2d SheetPoint(const Eigen::Vector2d& p_W) const;
  /// Largest height within the ring, relative to the radius of the ring.
  double LargestHeight() const;

 private:
  double Along(const Eigen::Vector2d& p_W) const;
  double Raw(double q) const;
  double HeightAt(double q) const;
  double Slope(double q) const;

  double radius_m_, amount_ = 0.0, phase_ = 0.0, period_ = 1.0, begin_ = 0.0;
  int kind_ = 4;
  Eigen::Vector2d across_;
  std::vector<double> lengths_;  ///< Arc length along the paper at each step.
};

}  // namespace touchdown::tests
