#include "scenarios/datasets/euroc_sensor.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "scenarios/config/config_matrix.h"
#include "scenarios/config/config_reader.h"

namespace touchdown::datasets {
namespace {

constexpr std::array<std::string_view, 1> kDistortionModels = {"radial-tangential"};
constexpr models::Range kExactlyFour = models::Between(4, 4);

/// Throws InputError unless the 4x4 matrix is a rigid transform.
void RequirePose(const config::ConfigMatrix& matrix) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> T(matrix.data.data());
  constexpr double kRoundOff = 1e-4;
  const bool is_rotation = T.topLeftCorner<3, 3>().isUnitary(kRoundOff) && T.topLeftCorner<3, 3>().determinant() > 0.0;
  if (!is_rotation || T.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) {
    throw InputError("must be a rigid transform: a rotation and a translation, with last row 0 0 0 1");
  }
}

void DescribeMounting(models::ConfigVisitor& v, config::ConfigMatrix& T_BS) {
  config::DescribeMatrix(v, {"T_BS", "", true}, T_BS, kExactlyFour, kExactlyFour);
  v.Check("T_BS.data", [&T_BS] { RequirePose(T_BS); });
}

struct CameraKeys {
  config::ConfigMatrix T_BS;
  models::CameraModel model;
  double width_px = 0.0, height_px = 0.0;
  int distortion_model = 0;
};

void DescribeCamera(models::ConfigVisitor& v, CameraKeys& c) {
  DescribeMounting(v, c.T_BS);
  v.Numbers({"resolution", "", true}, {&c.width_px, &c.height_px}, models::kPixel, models::kImageSize_px);
  v.Numbers({"intrinsics", "", true}, {&c.model.fx_px, &c.model.fy_px, &c.model.cx_px, &c.model.cy_px}, models::kPixel,
            models::kAny);
  v.Choice({"distortion_model", "", true}, c.distortion_model, kDistortionModels);
  v.Numbers({"distortion_coefficients", "", true}, {&c.model.k1, &c.model.k2, &c.model.p1, &c.model.p2},
            models::kNoUnit, models::kAny);
  v.Check("intrinsics", [&c] {
    c.model.width_px = static_cast<int>(c.width_px);
    c.model.height_px = static_cast<int>(c.height_px);
    c.model.Validate();
  });
}

/// Reads the keys that `describe` names, and ignores others.
void ReadKnownKeys(const std::filesystem::path& file, const std::function<void(models::ConfigVisitor&)>& describe) {
  const config::ConfigNode root = config::ReadConfigFile(file);
  config::OriginByPath origins;
  config::ConfigReader reader(root, origins);
  describe(reader);
  config::OriginChecker checker(origins, root.origin);
  describe(checker);
}

Eigen::Isometry3d PoseOf(const config::ConfigMatrix& matrix) {
  Eigen::Isometry3d X_BS;
  X_BS.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix.data.data());
  return X_BS;
}

std::string MountingYaml(const Eigen::Isometry3d& X_BS) {
  std::string data;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      data += fmt::format("{}{}", data.empty() ? "" : ", ", X_BS.matrix()(row, column));
    }
  }
  return fmt::format("T_BS:\n  cols: 4\n  rows: 4\n  data: [{}]\n", data);
}

}  // namespace

EurocCamera ReadEurocCamera(const std::filesystem::path& file) {
  CameraKeys keys;
  ReadKnownKeys(file, [&keys](models::ConfigVisitor& v) { DescribeCamera(v, keys); });
  return {keys.model, PoseOf(keys.T_BS)};
}

Eigen::Isometry3d ReadEurocMounting(const std::filesystem::path& file) {
  config::ConfigMatrix T_BS;
  ReadKnownKeys(file, [&T_BS](models::ConfigVisitor& v) { DescribeMounting(v, T_BS); });
  return PoseOf(T_BS);
}

std::string EurocCameraYaml(const EurocCamera& camera, int rate_hz) {
  const models::CameraModel& c = camera.model;
  return fmt::format(
      "# Pose of the camera in the body frame\n{}"
      "sensor_type: camera\n"
      "rate_hz: {}\n"
      "resolution: [{}, {}]\n"
      "camera_model: pinhole\n"
      "intrinsics: [{}, {}, {}, {}]  # fu, fv, cu, cv\n"
      "distortion_model: radial-tangential\n"
      "distortion_coefficients: [{}, {}, {}, {}]  # k1, k2, p1, p2\n",
      MountingYaml(camera.X_BC), rate_hz, c.width_px, c.height_px, c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1,
      c.p2);
}

std::string EurocImuYaml(const Eigen::Isometry3d& X_BU, int rate_hz, double gyro_noise_rad_s_sqrt_hz,
                         double accelerometer_noise_m_s2_sqrt_hz) {
  return fmt::format(
      "# Pose of the IMU in the body frame\n{}"
      "sensor_type: imu\n"
      "rate_hz: {}\n"
      "gyroscope_noise_density: {}  # rad/s/sqrt(Hz)\n"
      "accelerometer_noise_density: {}  # m/s^2/sqrt(Hz)\n",
      MountingYaml(X_BU), rate_hz, gyro_noise_rad_s_sqrt_hz, accelerometer_noise_m_s2_sqrt_hz);
}

}  // namespace touchdown::datasets
