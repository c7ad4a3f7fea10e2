#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "estimator/overlay.h"
#include "models/time.h"

namespace touchdown::estimator {

/// Result of processing one frame.
enum class FrameStatus {
  kOk,        ///< The frame has a pose that may be used.
  kNotFound,  ///< The frame has no pose.
  kRejected,  ///< The frame has a pose that must not be used.
};

/// Name of a status in files: "ok", "not_found" or "rejected".
std::string_view Name(FrameStatus status);

/// Entry of the column `status` in tables: `reason`, or the name of the status if `reason` is empty.
std::string_view ReasonOrStatus(FrameStatus status, std::string_view reason);

/// Pose of the body estimated from one frame.
struct VisionPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// Estimated error covariance of (p_WB in m, rotation vector in W in rad).
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Choice between the two pose hypotheses of a planar pad (Sec. IV-C.2).
struct PoseChoice {
  enum class Reason {
    kGravity,  ///< The vertical of the chosen pose is nearer to the IMU's (Eq. 14).
    kArtwork,  ///< No IMU: letter and inner ring edge match the pad description better at the chosen pose.
    kFrontal,  ///< No IMU, and both poses match equally well: the chosen pose has the more frontal view of the pad.
  };
  Reason reason = Reason::kGravity;
  /// Measure for the chosen pose. kGravity: angle between its vertical and the IMU's, rad. kArtwork: RMS residual, m.
  /// kFrontal: angle between the pad normal and the optical axis, rad.
  double chosen = 0.0;
  double other = 0.0;  ///< The same measure for the pose that was not chosen.
};

/// Name of a reason in files: "gravity", "artwork" or "frontal".
std::string_view Name(PoseChoice::Reason reason);

/// Result of an estimator for one frame.
struct FrameResult {
  models::Tick mid_exposure = 0;
  FrameStatus status = FrameStatus::kNotFound;
  std::string reason;                ///< Why there is no usable pose, one of the strategy's reasons; empty when kOk.
  std::optional<VisionPose> pose;    ///< Unfiltered. Present when kOk and kRejected.
  std::optional<PoseChoice> choice;  ///< Present when the pose was chosen from two hypotheses.
  std::optional<Eigen::Vector2d> pad_px;  ///< Center of the detected pad, raw px; present with a pose.
  std::optional<PixelBox> ring_box;       ///< Bounding box of the detected ring, raw px; present with a pose.
  Overlay overlay;
};

}  // namespace touchdown::estimator
