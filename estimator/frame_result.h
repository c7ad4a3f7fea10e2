#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "estimator/overlay.h"
#include "models/time.h"

namespace touchdown::estimator {

/// What came of a frame.
enum class FrameStatus {
  kOk,        ///< A pose that may be used.
  kNotFound,  ///< No pose.
  kRejected,  ///< A pose that must not be used.
};

/// "ok", "not_found" or "rejected".
std::string_view Name(FrameStatus status);

/// What the column `status` of a table holds: `reason`, or the status's name where there is no reason.
std::string_view ReasonOrStatus(FrameStatus status, std::string_view reason);

/// The body's pose as one frame gives it.
struct VisionPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// Covariance of the error that the estimator claims, of (p_WB in m, rotation vector in W in rad).
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// How one of the two pose hypotheses of a planar pad (Sec. IV-C.2) was chosen.
struct PoseChoice {
  enum class Reason {
    kGravity,  ///< Its vertical is nearer to the IMU's (Eq. 14).
    kPrint,    ///< No IMU: the H and the ring's inner edge fit the pad's description better under it.
    kFrontal,  ///< No IMU, and both fit alike: the pad is seen more squarely from the front.
  };
  Reason reason = Reason::kGravity;
  double chosen = 0.0;  ///< kGravity: angle between its vertical and the IMU's, rad. kPrint: RMS residual, m. kFrontal:
                        ///< angle between the pad's normal and the optical axis, rad.
  double other = 0.0;   ///< The same of the pose not chosen.
};

/// "gravity", "print" or "frontal".
std::string_view Name(PoseChoice::Reason reason);

/// What an estimator found in one frame.
struct FrameResult {
  models::Tick mid_exposure = 0;
  FrameStatus status = FrameStatus::kNotFound;
  std::string reason;                ///< Why there is no usable pose, one of the strategy's reasons; empty when kOk.
  std::optional<VisionPose> pose;    ///< Unfiltered. Present when kOk and kRejected.
  std::optional<PoseChoice> choice;  ///< Present with a pose of which there were two hypotheses.
  std::optional<Eigen::Vector2d> pad_px;  ///< Center of the detected pad, raw px; present with a pose.
  std::optional<PixelBox> ring_box;       ///< Encloses the detected ring, raw px; present with a pose.
  Overlay overlay;
};

}  // namespace touchdown::estimator
