#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::estimator {

/// How far a frame got: `kOk`, or the first stage that failed.
enum class FrameStatus {
  kOk,           ///< A pose that may be used.
  kNoComponent,  ///< No connected component is large enough to be classified.
  kNoCircle,     ///< No component was classified as a circle that the image's border does not cut.
  kNoH,          ///< No component was classified as a letter H.
  kNoPair,       ///< No H satisfies the geometric constraint with a circle (Sec. IV-A.4).
  kNoEllipse,    ///< No pair's ring gave an ellipse and a pose on whose plane the print is the described one.
  kOutlier,      ///< The pose jumps from the previous ones (Sec. IV-C.2).
};

/// "ok", "no_component", "no_circle", "no_h", "no_pair", "no_ellipse", "outlier".
std::string_view Name(FrameStatus status);

/// The body's pose as one frame gives it.
struct VisionPose {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// Of (p_WB in m, rotation vector in W in rad): the 1-sigma error that the estimator claims.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// What the estimator saw on its way: for drawing and for the logs, never for control.
struct FrameTrace {
  enum class Label { kCircle, kH, kOther };
  struct Component {
    int u = 0, v = 0, width = 0, height = 0;  ///< Bounding box, px.
    Label label = Label::kOther;
    double probability = 0.0;  ///< Posterior of `label`.
  };
  struct Ellipse {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< Undistorted px, at the camera's own focal length.
    Eigen::Vector2d semi_axes = Eigen::Vector2d::Zero();
    double angle = 0.0;  ///< Of the major axis, from +u towards +v, rad, (-pi/2, pi/2].
  };
  std::vector<Component> components;
  std::optional<Ellipse> ring_outer, ring_inner, letter;
};

/// A bounding box in pixels: columns [u, u + width), rows [v, v + height).
struct PixelBox {
  int u = 0, v = 0, width = 0, height = 0;
};

/// Of the two poses from which a circle looks the same (Sec. IV-C.2), how one was chosen.
struct PoseChoice {
  enum class Reason {
    kGravity,  ///< Its vertical is nearer to the IMU's (Eq. 14).
    kPrint,    ///< No IMU: the H and the ring's inner edge, seen from it, fit the pad's description better.
    kFrontal,  ///< No IMU, and both fit alike: it sees the pad more squarely from the front.
  };
  Reason reason = Reason::kGravity;
  double chosen = 0.0;  ///< kGravity: its vertical's angle from the IMU's, rad. kPrint: RMS misfit, m. kFrontal: the
                        ///< pad's normal's angle from the optical axis, rad.
  double other = 0.0;   ///< The same of the pose not chosen.
};

/// "gravity", "print" or "frontal".
std::string_view Name(PoseChoice::Reason reason);

struct FrameEstimate {
  models::Tick mid_exposure = 0;
  FrameStatus status = FrameStatus::kNoComponent;
  std::optional<VisionPose> pose;         ///< Present when kOk, and when kOutlier, where it must not be used.
  std::optional<PoseChoice> choice;       ///< Present when there is a pose.
  std::optional<Eigen::Vector2d> pad_px;  ///< Centre of the detected pad, raw px; present with a pose.
  std::optional<PixelBox> ring_box;       ///< Encloses the detected ring, raw px; present with a pose.
  FrameTrace trace;
};

/// How the frames that an estimator is given belong together.
enum class FrameOrder {
  kFlight,  ///< A flight from the pad: the first pose is near (0, 0, 0.3 m) and level (Sec. VI-B.1), and after a frame
            ///< that shows no pad the next is soon there. In the other two every picture counts.
  kSequence,   ///< One film that begins anywhere.
  kUnrelated,  ///< Pictures that have nothing to do with each other.
};

/// The two parts of the work on a frame that the paper times apart (Sec. VI-B.4).
enum class FrameStage {
  kRecognition,  ///< From the image to what might be the pad (Sec. IV-A).
  kGeometry,     ///< From there to its pose: edges, ellipses, pose (Secs. IV-B and IV-C).
};

/// What every estimator is told of the world.
struct EstimatorSetup {
  models::CameraModel camera;
  models::LandingPad pad;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();  ///< The camera's calibrated mounting.
  models::TimeBase time;
  FrameOrder frame_order = FrameOrder::kFlight;
  /// Called whenever the work on a frame comes to a stage, for whoever times it; may be empty.
  std::function<void(FrameStage)> on_stage = nullptr;
};

/// A strategy that turns camera frames into poses. It knows the camera, the pad and the mounting from its construction,
/// and may remember earlier frames.
class Estimator {
 public:
  virtual ~Estimator() = default;

  /// `image` has the camera's size and a stride of at least its width (throws std::invalid_argument otherwise).
  /// `gravity_B` is the unit vector pointing down, in the body frame at mid-exposure, as the IMU has it; nullopt
  /// without an IMU. Frames come in the order of their exposure.
  virtual FrameEstimate Estimate(const models::ImageView& image, models::Tick mid_exposure,
                                 const std::optional<Eigen::Vector3d>& gravity_B) = 0;
};

}  // namespace touchdown::estimator
