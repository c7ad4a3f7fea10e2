#include "scenarios/laboratory/calibration_pattern.h"

#include <fmt/format.h>

#include "models/angles.h"

namespace touchdown::laboratory {
namespace {

constexpr double kSheetDepth_m = 0.0005;
constexpr double kFloorDepth_m = 0.001;
constexpr double kFloorHalfSize_m = 50.0;
constexpr double kInk = 0.08, kPaper = 0.88, kFloor = 0.45;

/// MJCF of a horizontal rectangle with a uniform gray level, centered at p_E.
std::string Rectangle(const Eigen::Isometry3d& X_WE, const Eigen::Vector3d& p_E, const Eigen::Vector2d& half_size_m,
                      double gray) {
  const Eigen::Vector3d p_W = X_WE * p_E;
  return fmt::format(
      "    <geom type='plane' pos='{} {} {}' euler='0 0 {}' size='{} {} 100' rgba='{gray} {gray} {gray} 1'/>\n",
      p_W.x(), p_W.y(), p_W.z(), models::TaitBryanFromRotation(X_WE.linear()).yaw, half_size_m.x(), half_size_m.y(),
      fmt::arg("gray", gray));
}

}  // namespace

std::vector<Eigen::Vector3d> Chessboard::Corners() const {
  std::vector<Eigen::Vector3d> corners;
  for (int row = 1; row < rows; ++row) {
    for (int column = 1; column < columns; ++column) {
      corners.emplace_back(square_m * column - half_size_m().x(), half_size_m().y() - square_m * row, 0.0);
    }
  }
  return corners;
}

std::vector<Eigen::Vector3d> Chessboard::OuterCorners() const {
  const Eigen::Vector2d half = half_size_m();
  return {
      {-half.x(), half.y(), 0.0}, {half.x(), half.y(), 0.0}, {half.x(), -half.y(), 0.0}, {-half.x(), -half.y(), 0.0}};
}

std::string ChessboardMjcf(const Chessboard& board, const Eigen::Isometry3d& X_WE) {
  const Eigen::Vector2d half = board.half_size_m();
  std::string geoms;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = row % 2; column < board.columns; column += 2) {
      const Eigen::Vector3d p_E(board.square_m * (column + 0.5) - half.x(), half.y() - board.square_m * (row + 0.5),
                                0.0);
      geoms += Rectangle(X_WE, p_E, Eigen::Vector2d::Constant(0.5 * board.square_m), kInk);
    }
  }
  geoms += Rectangle(X_WE, {0.0, 0.0, -kSheetDepth_m}, half.array() + board.border_m, kPaper);
  geoms += Rectangle(X_WE, {0.0, 0.0, -kFloorDepth_m}, Eigen::Vector2d::Constant(kFloorHalfSize_m), kFloor);
  return fmt::format(
      "<mujoco model='chessboard'>\n"
      "  <compiler angle='radian' coordinate='local'/>\n"
      "  <statistic center='0 0 0.5' extent='2'/>\n"
      "  <visual>\n"
      "    <headlight ambient='0 0 0' diffuse='0 0 0' specular='0 0 0'/>\n"
      "    <quality shadowsize='0' offsamples='0'/>\n"
      "  </visual>\n"
      "  <worldbody>\n"
      "    <light directional='true' castshadow='false' dir='0.35 0.2 -1' ambient='0.45 0.45 0.45' diffuse='0.5932 "
      "0.5932 0.5932' specular='0 0 0'/>\n"
      "{}"
      "  </worldbody>\n"
      "</mujoco>\n",
      geoms);
}

}  // namespace touchdown::laboratory
