#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// A ROS 1 bag: its pictures (sensor_msgs/Image or CompressedImage) and, where they are there, the CameraInfo beside
/// them, the samples of an IMU, and from /tf_static how both are mounted on the body: base_link, or without such a
/// frame the one on which everything else is. The time of a message is its stamp, or when it has none, when it was
/// recorded. A camera that is not plumb_bob, or not calibrated, counts as none.
///
/// A bag that FlightBag wrote holds the flight's scenario: all that the flight's estimator was told is then as in the
/// flight, to the last bit, and so are its times.
class BagFile final : public Footage {
 public:
  /// `topics` are chosen from where a bag has several of pictures, or of IMUs. Throws InputError, naming the file, when
  /// it is no bag or is cut, has no pictures, has several topics of them or of IMUs of which none was chosen, or none
  /// that was; when times do not rise; and when this build knows no bags.
  BagFile(const std::filesystem::path& file, const std::vector<std::string>& topics);
  ~BagFile() override;

  const FootageFacts& facts() const override;

  /// Throws InputError for a picture that cannot be read, as one with the colors of a Bayer pattern.
  std::optional<FootageFrame> Next() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::datasets
