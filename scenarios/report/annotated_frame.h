#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>

#include "estimator/frame_result.h"
#include "models/camera_model.h"
#include "models/signals.h"

namespace touchdown::report {

/// What AnnotateFrame draws into a camera frame.
struct FrameAnnotation {
  estimator::Overlay overlay;
  std::optional<Eigen::Vector2d> pad_px;  ///< Center of the detected pad, raw px.
  std::optional<Eigen::Isometry3d> X_WC;  ///< Estimated camera pose.
  double axis_length_m = 0.09;            ///< Length of the drawn axes of W, about the outer radius of the pad.
};

/// Returns a color copy (BGR) of `image` with the annotation drawn on it.
///
/// Boxes, ellipses with their axes, polylines and labels of the overlay have the colors of their roles, as in the paper
/// (Sec. IV-A, Figs. 2 and 5): outlines green, markings blue, fits yellow, all others red and thin. An orange cross
/// marks the center of the pad. The axes of W, projected through the lens from the estimated pose, are red (X), green
/// (Y) and blue (Z). Line widths scale with the frame size; they are 1 and 2 px at 640x480. `image` must have the size
/// of the camera.
cv::Mat3b AnnotateFrame(const models::ImageView& image, const models::CameraModel& camera,
                        const FrameAnnotation& annotation);

/// Caption color of a frame: white for status `ok`, yellow for any other status.
cv::Scalar CaptionColor(estimator::FrameStatus status);

/// Height of the caption strip for an image, px: 27 at 640x480.
int CaptionHeight(const cv::Size& image);

/// Fills `strip` with black and draws one line of text into it, for example
/// DrawCaption(image.rowRange(0, height), ...). The text size follows the strip height; a text that is too long is
/// drawn smaller.
void DrawCaption(cv::Mat3b strip, const std::string& text, const cv::Scalar& color);

}  // namespace touchdown::report
