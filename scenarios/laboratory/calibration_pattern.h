#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace touchdown::laboratory {

/// A chessboard on a white sheet, as camera calibration uses it (Sec. III-D). Frame E: origin at the board's center, X
/// along its rows, Y along its columns, Z out of the sheet. The square at the end of +Y and -X is black; an even and an
/// odd number of squares tell the board from itself turned by 180 degrees.
struct Chessboard {
  int columns = 9;         ///< Squares along X.
  int rows = 6;            ///< Squares along Y.
  double square_m = 0.04;  ///< Of a square's side; with the sheet about it that is A3.
  double border_m = 0.03;  ///< White around the squares.

  Eigen::Vector2d half_size_m() const { return 0.5 * square_m * Eigen::Vector2d(columns, rows); }
  /// How many corners four squares share, along X and Y.
  cv::Size corner_count() const { return {columns - 1, rows - 1}; }
  /// These corners in E, row by row from +Y down, each from -X on: as OpenCV lists them in a picture.
  std::vector<Eigen::Vector3d> Corners() const;
  /// The outer corners of the board in E.
  std::vector<Eigen::Vector3d> OuterCorners() const;
};

/// A model of the sheet on a plain floor, lit as a flight's room, for sim::Renderer. The board lies at `X_WE`, whose Z
/// is up, at z = 0. Its squares are solid shapes: their edges are where they should be, at any distance.
std::string ChessboardMjcf(const Chessboard& board, const Eigen::Isometry3d& X_WE);

}  // namespace touchdown::laboratory
