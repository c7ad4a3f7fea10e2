#include "scenarios/config/camera_info.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "models/camera_model.h"
#include "scenarios/config/config_matrix.h"
#include "scenarios/config/config_reader.h"

namespace touchdown::config {
namespace {

constexpr std::array<std::string_view, 1> kDistortionModels = {"plumb_bob"};

/// Content of a file in the format of the ROS package camera_calibration_parsers.
struct CameraInfo {
  int width_px = 0;
  int height_px = 0;
  std::string camera_name;
  int distortion_model = 0;
  ConfigMatrix camera_matrix;
  ConfigMatrix distortion_coefficients;
  ConfigMatrix rectification_matrix;
  ConfigMatrix projection_matrix;
};

models::CameraModel ModelOf(const CameraInfo& info) {
  const std::vector<double>&k = info.camera_matrix.data, &d = info.distortion_coefficients.data;
  return {.width_px = info.width_px,
          .height_px = info.height_px,
          .fx_px = k[0],
          .fy_px = k[4],
          .cx_px = k[2],
          .cy_px = k[5],
          .k1 = d[0],
          .k2 = d[1],
          .p1 = d[2],
          .p2 = d[3],
          .k3 = d.size() > 4 ? d[4] : 0.0};
}

/// Throws InputError if the matrix does not have the layout: "0" and "1" are required values, "f..." is a positive
/// focal length, and other items are arbitrary.
void RequireLayout(const ConfigMatrix& matrix, std::initializer_list<std::string_view> layout) {
  const auto holds = [](std::string_view item, double value) {
    if (item == "0") return value == 0.0;
    if (item == "1") return value == 1.0;
    return !item.starts_with('f') || value > 0.0;
  };
  if (!std::equal(layout.begin(), layout.end(), matrix.data.begin(), holds)) {
    throw InputError(fmt::format("must be [{}], is [{}]", fmt::join(layout, ", "), fmt::join(matrix.data, ", ")));
  }
}

void Describe(models::ConfigVisitor& v, CameraInfo& info) {
  constexpr models::Range kOne = models::Between(1, 1), kThree = models::Between(3, 3), kFour = models::Between(4, 4);
  v.Integer({"image_width", "", true}, info.width_px, models::kImageSize_px);
  v.Integer({"image_height", "", true}, info.height_px, models::kImageSize_px);
  v.Text({"camera_name", ""}, info.camera_name);
  v.Choice({"distortion_model", "", true}, info.distortion_model, kDistortionModels);
  DescribeMatrix(v, {"camera_matrix", "", true}, info.camera_matrix, kThree, kThree);
  DescribeMatrix(v, {"distortion_coefficients", "", true}, info.distortion_coefficients, kOne, models::Between(4, 5));
  DescribeMatrix(v, {"rectification_matrix", ""}, info.rectification_matrix, kThree, kThree);
  DescribeMatrix(v, {"projection_matrix", ""}, info.projection_matrix, kThree, kFour);
  v.Check("camera_matrix.data", [&info] {
    RequireLayout(info.camera_matrix, {"fx", "0", "cx", "0", "fy", "cy", "0", "0", "1"});
  });
  v.Check("distortion_coefficients.data", [&info] { ModelOf(info).Validate(); });
  v.Check("rectification_matrix.data", [&matrix = info.rectification_matrix] {
    if (!matrix.data.empty()) RequireLayout(matrix, {"1", "0", "0", "0", "1", "0", "0", "0", "1"});
  });
  v.Check("projection_matrix.data", [&matrix = info.projection_matrix] {
    if (!matrix.data.empty()) {
      RequireLayout(matrix, {"fx'", "0", "cx'", "0", "0", "fy'", "cy'", "0", "0", "0", "1", "0"});
    }
  });
}

}  // namespace

bool IsCameraInfo(const ConfigNode& root) {
  constexpr std::array<std::string_view, 5> kCameraInfoKeys = {"image_width", "image_height", "camera_matrix",
                                                               "distortion_model", "distortion_coefficients"};
  return std::any_of(kCameraInfoKeys.begin(), kCameraInfoKeys.end(),
                     [&root](auto key) { return root.Find(key) != nullptr; });
}

ConfigNode CameraModelFromCameraInfo(const ConfigNode& root) {
  ReadAlone<CameraInfo>(root);
  const auto item = [&root](std::string_view matrix, std::size_t index) {
    return root.Find(matrix)->Find("data")->items[index];
  };
  ConfigNode keys;
  keys.kind = ConfigNode::Kind::kKeys;
  keys.origin = root.origin;
  keys.keys = {{"width_px", *root.Find("image_width")},    {"height_px", *root.Find("image_height")},
               {"fx_px", item("camera_matrix", 0)},        {"fy_px", item("camera_matrix", 4)},
               {"cx_px", item("camera_matrix", 2)},        {"cy_px", item("camera_matrix", 5)},
               {"k1", item("distortion_coefficients", 0)}, {"k2", item("distortion_coefficients", 1)},
               {"p1", item("distortion_coefficients", 2)}, {"p2", item("distortion_coefficients", 3)}};
  constexpr std::size_t kCoefficientsWithK3 = 5;
  if (root.Find("distortion_coefficients")->Find("data")->items.size() == kCoefficientsWithK3) {
    keys.keys.push_back({"k3", item("distortion_coefficients", 4)});
  }
  return keys;
}

std::string CameraInfoYaml(const models::CameraModel& c, const std::string& camera_name) {
  return fmt::format(
      "image_width: {}\n"
      "image_height: {}\n"
      "camera_name: {}\n"
      "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [{fx}, 0, {cx}, 0, {fy}, {cy}, 0, 0, 1]\n"
      "distortion_model: plumb_bob\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [{}, {}, {}, {}, {}]\n"
      "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
      "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [{fx}, 0, {cx}, 0, 0, {fy}, {cy}, 0, 0, 0, 1, 0]\n",
      c.width_px, c.height_px, camera_name, c.k1, c.k2, c.p1, c.p2, c.k3, fmt::arg("fx", c.fx_px),
      fmt::arg("fy", c.fy_px), fmt::arg("cx", c.cx_px), fmt::arg("cy", c.cy_px));
}

}  // namespace touchdown::config
