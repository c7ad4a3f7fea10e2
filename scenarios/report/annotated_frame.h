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

/// What is drawn into a frame.
struct FrameAnnotation {
  estimator::Overlay overlay;
  std::optional<Eigen::Vector2d> pad_px;  ///< Center of the detected pad, raw px.
  std::optional<Eigen::Isometry3d> X_WC;  ///< The camera's estimated pose.
  double axis_length_m = 0.09;            ///< Of the axes that show that pose: about the pad's outer radius.
};

/// A frame in color (blue, green, red) with the estimator's overlay: boxes, ellipses with their axes, polylines and
/// labels in the colors of their roles, as in the paper (Sec. IV-A, Figs. 2 and 5): outlines green, markings blue, fits
/// yellow, others red and thin. An orange cross lies on the pad, and the axes of W are drawn as the estimated pose
/// projects them through the lens, X red, Y green, Z blue. Line widths scale with the frame's size and are 1 and 2 px
/// at 640x480. `image` has the camera's size.
cv::Mat3b AnnotateFrame(const models::ImageView& image, const models::CameraModel& camera,
                        const FrameAnnotation& annotation);

/// White, or yellow when a frame gave no pose: the color of its caption.
cv::Scalar CaptionColor(estimator::FrameStatus status);

/// How high a caption suits a picture, px: 27 at 640x480.
int CaptionHeight(const cv::Size& picture);

/// Makes a black strip with a line of text of a picture's rows, as in DrawCaption(picture.rowRange(0, height), ...).
/// The text is as high as suits the strip, or smaller where it is too long for it.
void DrawCaption(cv::Mat3b strip, const std::string& text, const cv::Scalar& color);

}  // namespace touchdown::report
