#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace touchdown::laboratory {

/// Chessboard on a white sheet for camera calibration (Sec. III-D). Frame E: origin at the center of the board, X along
/// its rows, Y along its columns, Z out of the sheet. The square at the corner towards -X and +Y is black. One number
/// of squares is odd and the other even, so that the board differs from its rotation by 180 degrees.
struct Chessboard {
  int columns = 9;         ///< Squares along X.
  int rows = 6;            ///< Squares along Y.
  double square_m = 0.04;  ///< Side of a square; with the border, the default board fills an A3 sheet.
  double border_m = 0.03;  ///< Width of the white border around the squares.

  Eigen::Vector2d half_size_m() const { return 0.5 * square_m * Eigen::Vector2d(columns, rows); }
  /// Number of inner corners (where four squares meet) along X and Y.
  cv::Size corner_count() const { return {columns - 1, rows - 1}; }
  /// Inner corners in E, in OpenCV's order: rows from +Y to -Y, each from -X to +X.
  std::vector<Eigen::Vector3d> Corners() const;
  /// The outer corners of the board in E.
  std::vector<Eigen::Vector3d> OuterCorners() const;
};

/// MuJoCo model of the sheet on a uniform floor with the light of a flight scene, for sim::Renderer. X_WE is the pose
/// of the board: Z up, at z = 0. The squares are geoms, not a texture, so that their edges are exact at any distance.
std::string ChessboardMjcf(const Chessboard& board, const Eigen::Isometry3d& X_WE);

}  // namespace touchdown::laboratory
