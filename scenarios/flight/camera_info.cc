#include "scenarios/flight/camera_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::scenarios {
namespace {

constexpr std::array<std::string_view, 8> kKnownKeys = {"image_width",          "image_height",
                                                        "camera_name",          "camera_matrix",
                                                        "distortion_model",     "distortion_coefficients",
                                                        "rectification_matrix", "projection_matrix"};

const ConfigNode& Require(const ConfigNode& parent, std::string_view key, const std::string& path) {
  const ConfigNode* const node = parent.Find(key);
  if (node == nullptr) throw ConfigError(parent.origin, path, "must be given");
  return *node;
}

std::vector<ConfigNode> Data(const ConfigNode& root, const std::string& key, std::size_t least, std::size_t most) {
  const ConfigNode& matrix = Require(root, key, key);
  const ConfigNode& data = Require(matrix, "data", key + ".data");
  if (data.kind != ConfigNode::Kind::kList || data.items.size() < least || data.items.size() > most) {
    throw ConfigError(data.origin, key + ".data", fmt::format("must be a list of {} numbers", most));
  }
  return data.items;
}

bool IsZero(const ConfigNode& node) {
  return node.kind == ConfigNode::Kind::kText && !node.quoted && !node.text.empty() &&
         node.text.find_first_not_of("-+0.") == std::string::npos && node.text.find('0') != std::string::npos;
}

}  // namespace

bool IsCameraInfo(const ConfigNode& root) {
  return root.Find("image_width") != nullptr || root.Find("camera_matrix") != nullptr;
}

ConfigNode CameraModelFromCameraInfo(const ConfigNode& root) {
  for (const auto& [key, node] : root.keys) {
    if (std::find(kKnownKeys.begin(), kKnownKeys.end(), key) == kKnownKeys.end()) {
      throw ConfigError(node.origin, key, "unknown key of a camera_info calibration");
    }
  }
  const ConfigNode& model = Require(root, "distortion_model", "distortion_model");
  if (model.text != "plumb_bob") throw ConfigError(model.origin, "distortion_model", "must be plumb_bob");

  const std::vector<ConfigNode> matrix = Data(root, "camera_matrix", 9, 9);
  for (const std::size_t index : {1, 3, 6, 7}) {
    if (!IsZero(matrix[index])) {
      throw ConfigError(matrix[index].origin, "camera_matrix.data", "must be [fx, 0, cx, 0, fy, cy, 0, 0, 1]");
    }
  }
  const std::vector<ConfigNode> distortion = Data(root, "distortion_coefficients", 4, 5);
  for (std::size_t index = 2; index < distortion.size(); ++index) {
    if (!IsZero(distortion[index])) {
      throw ConfigError(distortion[index].origin, "distortion_coefficients.data",
                        "only the first two terms (k1, k2) may differ from 0");
    }
  }

  ConfigNode keys;
  keys.kind = ConfigNode::Kind::kKeys;
  keys.origin = root.origin;
  keys.keys = {{"width_px", Require(root, "image_width", "image_width")},
               {"height_px", Require(root, "image_height", "image_height")},
               {"fx_px", matrix[0]},
               {"fy_px", matrix[4]},
               {"cx_px", matrix[2]},
               {"cy_px", matrix[5]},
               {"k1", distortion[0]},
               {"k2", distortion[1]}};
  return keys;
}

}  // namespace touchdown::scenarios
