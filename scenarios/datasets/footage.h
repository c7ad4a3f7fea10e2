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

/// A picture of footage.
struct FootageFrame {
  std::string source;                        ///< Name of the file that it comes from.
  std::optional<models::Tick> mid_exposure;  ///< nullopt where the footage tells no times.
  models::Image image;
};

/// A sample of the IMU, and whether the vehicle knew that it stood on the ground, motors off.
struct ImuReading {
  models::ImuSample sample;
  bool at_rest = false;
};

/// Where camera and IMU sit on the body.
struct SensorMounting {
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_BU = Eigen::Isometry3d::Identity();
};

/// What footage tells beside its pictures. Only a recording of a flight tells everything.
struct FootageFacts {
  estimator::FrameOrder frame_order = estimator::FrameOrder::kUnrelated;
  models::TimeBase time{.ticks_per_s =
                            1'000'000};  ///< What ticks count: microseconds, unless a recording knows better.
  std::size_t frame_count = 0;           ///< 0: not known beforehand.
  double frames_per_s = 2.0;             ///< For a film of it; pictures without times pass at leisure.
  /// From mid-exposure to when the estimator was given the frame, before the IMU's sample of that tick; nullopt where
  /// nobody tells.
  std::optional<models::Tick> latency;
  std::optional<models::CameraModel> camera;
  std::optional<models::LandingPad> pad;
  std::optional<SensorMounting> mounting;
  std::vector<ImuReading> imu;  ///< Rising in time.
  std::optional<estimator::EstimatorConfig> estimator;
};

/// Pictures from a file or a folder, one after the other.
class Footage {
 public:
  virtual ~Footage() = default;

  virtual const FootageFacts& facts() const = 0;

  /// nullopt after the last one. Throws InputError, naming the file, for a picture that cannot be read.
  virtual std::optional<FootageFrame> Next() = 0;
};

/// Opens a folder of images (ImageFolder), a recording in EuRoC's layout (EurocFolder), a ROS bag (BagFile: its name
/// ends in .bag) or a video (VideoFile). `topics` are to be chosen from a bag's. Throws InputError, naming `input`,
/// when it is none of these, or empty, or has no topics to choose from.
std::unique_ptr<Footage> OpenFootage(const std::filesystem::path& input, const std::vector<std::string>& topics = {});

}  // namespace touchdown::datasets
