#include "scenarios/datasets/footage.h"

#include <fmt/format.h>

#include "models/error.h"
#include "scenarios/datasets/bag_file.h"
#include "scenarios/datasets/euroc_folder.h"
#include "scenarios/datasets/image_folder.h"
#include "scenarios/datasets/video_file.h"

namespace touchdown::datasets {

std::unique_ptr<Footage> OpenFootage(const std::filesystem::path& input, const std::vector<std::string>& topics) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(input, error);
  if (!fs::exists(status)) throw InputError(fmt::format("{}: no such file or directory", input.string()));
  if (!fs::is_directory(status) && input.extension() == ".bag") return std::make_unique<BagFile>(input, topics);
  if (!topics.empty())
    throw InputError(fmt::format("{}: not a ROS bag; --topic is allowed only for ROS bags", input.string()));
  if (!fs::is_directory(status)) return std::make_unique<VideoFile>(input);
  if (const auto recording = FindEurocFolder(input)) return std::make_unique<EurocFolder>(*recording);
  return std::make_unique<ImageFolder>(input);
}

}  // namespace touchdown::datasets
