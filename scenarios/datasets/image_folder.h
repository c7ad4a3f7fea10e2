#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// The file's picture in gray, as stored: a camera's note of how it was held (EXIF) turns nothing, since a calibration
/// is of the sensor. Throws InputError, naming the file, when it cannot be read.
models::Image ReadGrayImage(const std::filesystem::path& file);

/// A folder of pictures that have nothing to do with each other: every file that OpenCV reads by its name's ending, in
/// the order of the names, numbers in them by their value. Folders within it are not looked into.
class ImageFolder final : public Footage {
 public:
  /// Throws InputError for a folder without a picture.
  explicit ImageFolder(const std::filesystem::path& folder);

  const FootageFacts& facts() const override { return facts_; }
  std::optional<FootageFrame> Next() override;

 private:
  FootageFacts facts_;
  std::vector<std::filesystem::path> files_;
  std::size_t next_ = 0;
};

}  // namespace touchdown::datasets
