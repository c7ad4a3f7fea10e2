#include "scenarios/flight/camera_info.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "models/camera_model.h"
#include "scenarios/flight/config_reader.h"

namespace touchdown::scenarios {
namespace {

constexpr std::array<std::string_view, 1> kDistortionModels = {"plumb_bob"};

/// Row by row; empty when it is not given.
struct Matrix {
  int rows = 0;
  int cols = 0;
  std::vector<double> data;
};

/// A file as ROS's camera_calibration_parsers write it.
struct CameraInfo {
  int width_px = 0;
  int height_px = 0;
  std::string camera_name;
  int distortion_model = 0;
  Matrix camera_matrix;
  Matrix distortion_coefficients;
  Matrix rectification_matrix;
  Matrix projection_matrix;
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
          .k2 = d[1]};
}

/// Throws InputError for a 0, a 1 or a focal length (f...) of the layout that is none in the matrix.
void RequireLayout(const Matrix& matrix, std::initializer_list<std::string_view> layout) {
  const auto holds = [](std::string_view item, double value) {
    if (item == "0") return value == 0.0;
    if (item == "1") return value == 1.0;
    return !item.starts_with('f') || value > 0.0;
  };
  if (!std::equal(layout.begin(), layout.end(), matrix.data.begin(), holds)) {
    throw InputError(fmt::format("must be [{}], is [{}]", fmt::join(layout, ", "), fmt::join(matrix.data, ", ")));
  }
}

void RequireRadial(const Matrix& coefficients) {
  if (std::any_of(coefficients.data.begin() + 2, coefficients.data.end(), [](double value) { return value != 0.0; })) {
    throw InputError("only the first two terms (k1, k2) may differ from 0");
  }
}

void DescribeMatrix(ConfigVisitor& v, const Key& key, Matrix& matrix, const Range& rows, const Range& cols) {
  v.Section(key, {}, [&](ConfigVisitor& m) {
    m.Integer({"rows", "", true}, matrix.rows, rows);
    m.Integer({"cols", "", true}, matrix.cols, cols);
    matrix.data.resize(static_cast<std::size_t>(matrix.rows) * static_cast<std::size_t>(matrix.cols));
    std::vector<double*> data;
    for (double& value : matrix.data) data.push_back(&value);
    m.Numbers({"data", "", true}, data, kNoUnit, kAny);
  });
}

void Describe(ConfigVisitor& v, CameraInfo& info) {
  constexpr Range kOne = Between(1, 1), kThree = Between(3, 3), kFour = Between(4, 4);
  v.Integer({"image_width", "", true}, info.width_px, kImageSize_px);
  v.Integer({"image_height", "", true}, info.height_px, kImageSize_px);
  v.Text({"camera_name", ""}, info.camera_name);
  v.Choice({"distortion_model", "", true}, info.distortion_model, kDistortionModels);
  DescribeMatrix(v, {"camera_matrix", "", true}, info.camera_matrix, kThree, kThree);
  DescribeMatrix(v, {"distortion_coefficients", "", true}, info.distortion_coefficients, kOne, Between(4, 5));
  DescribeMatrix(v, {"rectification_matrix", ""}, info.rectification_matrix, kThree, kThree);
  DescribeMatrix(v, {"projection_matrix", ""}, info.projection_matrix, kThree, kFour);
  v.Check("camera_matrix.data", [&info] {
    RequireLayout(info.camera_matrix, {"fx", "0", "cx", "0", "fy", "cy", "0", "0", "1"});
  });
  v.Check("distortion_coefficients.data", [&info] {
    RequireRadial(info.distortion_coefficients);
    ModelOf(info).Validate();
  });
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
  constexpr std::array<std::string_view, 5> kTelling = {"image_width", "image_height", "camera_matrix",
                                                        "distortion_model", "distortion_coefficients"};
  return std::any_of(kTelling.begin(), kTelling.end(), [&root](auto key) { return root.Find(key) != nullptr; });
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
               {"k1", item("distortion_coefficients", 0)}, {"k2", item("distortion_coefficients", 1)}};
  return keys;
}

}  // namespace touchdown::scenarios
