#include "scenarios/config/file_format.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenarios/config/camera_info.h"

namespace touchdown::config {
namespace {

struct FileFormat {
  std::string_view name;
  bool (*matches)(const ConfigNode& root);
  ConfigNode (*keys)(const ConfigNode& root);
};
constexpr std::array<FileFormat, 1> kFileFormats = {{{"camera_info", IsCameraInfo, CameraModelFromCameraInfo}}};

}  // namespace

ConfigNode SectionKeys(ConfigNode root, const models::SectionFile& file) {
  if (file.format.empty()) return root;
  const auto format = std::find_if(kFileFormats.begin(), kFileFormats.end(),
                                   [&file](const FileFormat& known) { return known.name == file.format; });
  if (format == kFileFormats.end()) throw std::logic_error("no reader for the format " + std::string(file.format));
  if (!format->matches(root)) return root;
  ConfigNode keys = format->keys(root);
  if (file.format_key.empty()) return keys;
  ConfigNode section;
  section.kind = ConfigNode::Kind::kKeys;
  section.origin = root.origin;
  section.keys.push_back({std::string(file.format_key), std::move(keys)});
  return section;
}

}  // namespace touchdown::config
