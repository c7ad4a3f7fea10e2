#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// Reads images from a ROS 1 bag (sensor_msgs/Image or CompressedImage) and, when the bag contains them, the CameraInfo
/// of the image topic, the samples of an IMU, and the mounting of camera and IMU from /tf_static. The body frame is
/// base_link, or the root of the frame tree when there is no base_link. The time of a message is its stamp, or its
/// recording time when the stamp is zero. A CameraInfo without a calibration, or with another distortion model than
/// plumb_bob, is ignored.
///
/// A bag written by FlightBag contains the scenario of the flight. Then times and estimator inputs are bit-identical to
/// those of the flight.
class BagFile final : public Footage {
 public:
  /// `topics` selects the image topic and the IMU topic; it may be empty when the bag has at most one of each. Throws
  /// InputError, naming the file, when it is not a bag or is truncated, when it has no images, when a selected topic
  /// does not exist, when several topics are left to choose from, when times do not increase, and when this build has
  /// no bag support.
  BagFile(const std::filesystem::path& file, const std::vector<std::string>& topics);
  ~BagFile() override;

  const FootageMetadata& metadata() const override;

  /// Throws InputError for an image that cannot be read or has an unsupported encoding, for example a Bayer pattern.
  std::optional<FootageFrame> Next() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::datasets
