#pragma once

#include <filesystem>
#include <vector>

#include "scenarios/datasets/footage.h"

namespace touchdown::datasets {

/// Reads an image file and converts it to gray. EXIF orientation is ignored, because a camera calibration refers to the
/// sensor. Throws InputError, naming the file, when it cannot be read.
models::Image ReadGrayImage(const std::filesystem::path& file);

/// Reads a directory of unrelated images: all files with the extension of a supported image format, in natural order of
/// their names (shot9 before shot10). Subdirectories are ignored.
class ImageFolder final : public Footage {
 public:
  /// Throws InputError for a directory without images.
  explicit ImageFolder(const std::filesystem::path& folder);

  const FootageMetadata& metadata() const override { return metadata_; }
  std::optional<FootageFrame> Next() override;

 private:
  FootageMetadata metadata_;
  std::vector<std::filesystem::path> files_;
  std::size_t next_ = 0;
};

}  // namespace touchdown::datasets
