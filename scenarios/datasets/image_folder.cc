#include "scenarios/datasets/image_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <system_error>

#include "models/error.h"
#include "scenarios/datasets/gray_image.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

bool IsImageFile(const fs::path& file) {
  constexpr std::array<std::string_view, 10> kEndings = {".png", ".jpg",  ".jpeg", ".bmp",  ".pgm",
                                                         ".ppm", ".tiff", ".tif",  ".webp", ".jp2"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace

models::Image ReadGrayImage(const fs::path& file) {
  cv::Mat gray;
  try {
    gray = cv::imread(file.string(), cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    gray.release();
  }
  if (gray.empty()) throw InputError(fmt::format("{}: not a readable image", file.string()));
  return ToGrayImage(gray);
}

ImageFolder::ImageFolder(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->is_regular_file() && IsImageFile(entry->path())) files_.push_back(entry->path());
  }
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  if (files_.empty()) throw InputError(fmt::format("{}: no images in this directory", folder.string()));
  std::sort(files_.begin(), files_.end(), [](const fs::path& a, const fs::path& b) {
    return strverscmp(a.filename().c_str(), b.filename().c_str()) < 0;  // GNU extension: compares digits as numbers.
  });
  metadata_.frame_count = files_.size();
}

std::optional<FootageFrame> ImageFolder::Next() {
  if (next_ == files_.size()) return std::nullopt;
  const fs::path& file = files_[next_++];
  return FootageFrame{file.filename().string(), std::nullopt, ReadGrayImage(file)};
}

}  // namespace touchdown::datasets
