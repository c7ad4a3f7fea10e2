#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/attitude_estimator.h"
#include "estimator/frame_result.h"
#include "estimator/make_estimator.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"
#include "models/signals.h"
#include "models/time.h"

namespace touchdown::datasets {

/// One frame of footage.
struct FootageFrame {
  std::string source;                        ///< Name of the file that contains it.
  std::optional<models::Tick> mid_exposure;  ///< nullopt when the footage has no times.
  models::Image image;
};

/// An IMU sample and the signal that the vehicle stands on the ground with motors off.
struct ImuReading {
  models::ImuSample sample;
  bool at_rest = false;
};

/// Poses of camera and IMU in the body frame.
struct SensorMounting {
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_BU = Eigen::Isometry3d::Identity();
};

/// Metadata of footage. It is complete only for a recording of a flight.
struct FootageMetadata {
  estimator::FrameOrder frame_order = estimator::FrameOrder::kUnrelated;
  /// Unit of ticks: 1 us, or the tick of the flight for a recording of a flight.
  models::TimeBase time{.ticks_per_s = 1'000'000};
  std::size_t frame_count = 0;  ///< 0 when unknown.
  double frames_per_s = 2.0;    ///< Frame rate of a video of the footage; the default is for frames without times.
  /// Latency from mid-exposure to delivery of the frame to the estimator; nullopt when unknown. A frame is delivered
  /// before the IMU sample of the same tick.
  std::optional<models::Tick> latency;
  std::optional<models::CameraModel> camera;
  std::optional<models::LandingPad> pad;
  std::optional<SensorMounting> mounting;
  std::vector<ImuReading> imu;  ///< In increasing order of time.
  std::optional<estimator::EstimatorConfig> estimator;
};

/// Sequence of frames from a file or a directory.
class Footage {
 public:
  virtual ~Footage() = default;

  virtual const FootageMetadata& metadata() const = 0;

  /// Reads the next frame; nullopt after the last. Throws InputError, naming the file, when it cannot be read.
  virtual std::optional<FootageFrame> Next() = 0;
};

/// Opens a directory of images (ImageFolder), a recording in the EuRoC layout (EurocFolder), a ROS bag, whose file name
/// ends in .bag (BagFile), or a video (VideoFile). `topics` selects topics of a bag and must be empty for other inputs.
/// Throws InputError, naming `input`, when it is none of these or is empty, and when `topics` is not allowed.
std::unique_ptr<Footage> OpenFootage(const std::filesystem::path& input, const std::vector<std::string>& topics = {});

}  // namespace touchdown::datasets
