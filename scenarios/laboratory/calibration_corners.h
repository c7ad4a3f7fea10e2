#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "models/camera_model.h"
#include "models/signals.h"
#include "scenarios/laboratory/calibration_pattern.h"

namespace touchdown::laboratory {

/// Positions of the corners in an image, raw px, in the order of Chessboard::Corners.
using ImageCorners = std::vector<Eigen::Vector2d>;

/// Detects the corners of the board with subpixel accuracy; nullopt when the board is not completely visible.
std::optional<ImageCorners> FindCorners(const models::ImageView& image, const Chessboard& board);

/// Camera model and poses fitted to several views of a board.
struct CameraFit {
  models::CameraModel model;
  std::vector<std::optional<Eigen::Isometry3d>> X_EC;  ///< One per view; nullopt for excluded views.
  double rms_px = 0.0;                                 ///< RMS reprojection error of the corners, px.
};

/// Distortion coefficients to estimate; the others are 0.
enum class LensTerms {
  kRadial,  ///< k1 and k2, as in the paper (Sec. IV-B).
  kAll,     ///< k1, k2, k3 and the tangential p1 and p2.
};

/// Fits a camera model to views of a board with OpenCV's calibrateCamera, which follows the toolbox used in the paper
/// (Zhang 2000, Bouguet). Excludes views with an RMS error above four times the median, which have a misdetected
/// corner, and repeats the fit. Throws InputError for fewer than 3 views, and when the fitted model is invalid.
CameraFit FitCamera(std::span<const ImageCorners> views, const Chessboard& board, int width_px, int height_px,
                    LensTerms terms = LensTerms::kRadial);

}  // namespace touchdown::laboratory
