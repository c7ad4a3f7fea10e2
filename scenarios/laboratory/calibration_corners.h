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

/// Where a picture shows the corners of Chessboard::Corners, in their order, raw px.
using SeenCorners = std::vector<Eigen::Vector2d>;

/// Finds the board in a picture, its corners to a fraction of a pixel; nullopt when it is not seen whole.
std::optional<SeenCorners> FindCorners(const models::ImageView& image, const Chessboard& board);

/// A camera as several views of a board tell it.
struct CameraFit {
  models::CameraModel model;
  std::vector<std::optional<Eigen::Isometry3d>> X_EC;  ///< One for each view; nullopt for those left out.
  double rms_px = 0.0;                                 ///< Distance of the corners from where the fit has them.
};

/// Which terms of the lens's distortion are sought; the others are 0.
enum class LensTerms {
  kRadial,  ///< k1 and k2, the paper's (Sec. IV-B).
  kAll,     ///< Also the tangential p1 and p2, and k3.
};

/// The camera that fits all views best, by OpenCV's calibrateCamera, which follows the toolbox that the paper used
/// (Zhang 2000, Bouguet). Views that fit over four times worse than most, in which a corner
/// was taken for something else, are left out. Throws InputError for fewer than 3 views, and when no valid camera fits
/// them.
CameraFit FitCamera(std::span<const SeenCorners> views, const Chessboard& board, int width_px, int height_px,
                    LensTerms terms = LensTerms::kRadial);

}  // namespace touchdown::laboratory
