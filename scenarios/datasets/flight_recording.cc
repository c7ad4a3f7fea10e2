#include "scenarios/datasets/flight_recording.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <regex>

#include "models/error.h"
#include "scenarios/config/camera_info.h"
#include "scenarios/datasets/euroc_sensor.h"
#include "scenarios/runner/tum_trajectory.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

InputError WriteError(const fs::path& file) {
  return InputError(fmt::format("recording: {} cannot be written", file.filename().string()));
}

/// Uses the fastest compression: image noise compresses poorly, and writing must not take longer than rendering.
void WritePng(const fs::path& file, const models::Image& image) {
  const cv::Mat mat(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data()));
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", mat, png, {cv::IMWRITE_PNG_COMPRESSION, 1})) throw WriteError(file);
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  stream.close();
  if (!stream) throw WriteError(file);
}

}  // namespace

bool IsFlightRecordingFile(const fs::path& file) {
  static const std::regex names(
      "scenario\\.yaml|camera\\.yaml|pad\\.yaml|mav0/cam0/(sensor\\.yaml|data\\.csv|data/[0-9]+\\.png)|"
      "mav0/imu0/(sensor\\.yaml|data\\.csv|at_rest\\.csv)|mav0/state_groundtruth_estimate0/data\\.csv");
  return std::regex_match(file.generic_string(), names);
}

FlightRecording::FlightRecording(const runner::Scenario& scenario, const fs::path& folder)
    : scenario_(scenario),
      folder_(folder),
      frames_csv_("#timestamp [ns],filename\n"),
      imu_csv_(
          "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
          "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n"),
      at_rest_csv_("#timestamp [ns],at_rest\n") {
  std::error_code error;
  for (const char* name : {"mav0/cam0/data", "mav0/imu0", "mav0/state_groundtruth_estimate0"}) {
    fs::create_directories(folder_ / name, error);
    if (error) throw InputError(fmt::format("recording: {}", error.message()));
  }
}

void FlightRecording::OnImu(const models::ImuSample& sample, bool at_rest) {
  const std::int64_t time_ns = scenario_.time.ToNanoseconds(sample.tick);
  const Eigen::Vector3d &w = sample.w_WU_U, &f = sample.specific_force_U;
  fmt::format_to(std::back_inserter(imu_csv_), "{},{},{},{},{},{},{}\n", time_ns, w.x(), w.y(), w.z(), f.x(), f.y(),
                 f.z());
  if (at_rest != at_rest_) fmt::format_to(std::back_inserter(at_rest_csv_), "{},{}\n", time_ns, at_rest ? 1 : 0);
  at_rest_ = at_rest;
}

void FlightRecording::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult&,
                              const runner::FrameRecord&) {
  const std::int64_t time_ns = scenario_.time.ToNanoseconds(frame.mid_exposure);
  const std::string name = fmt::format("{}.png", time_ns);
  fmt::format_to(std::back_inserter(frames_csv_), "{},{}\n", time_ns, name);
  WritePng(folder_ / "mav0" / "cam0" / "data" / name, frame.image);
}

void FlightRecording::Finish(const runner::FlightLog& log) {
  std::string truth_csv =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n";
  for (const auto& [tick, X_WB] : runner::TrueTrajectory(log)) {
    const Eigen::Vector3d p = X_WB.translation();
    const Eigen::Quaterniond q(X_WB.linear());
    fmt::format_to(std::back_inserter(truth_csv), "{},{},{},{},{},{},{},{}\n", scenario_.time.ToNanoseconds(tick),
                   p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z());
  }
  const models::CameraModel camera = scenario_.assumed_camera();
  const models::Vehicle vehicle = scenario_.assumed_vehicle();
  Write("mav0/cam0/data.csv", frames_csv_);
  Write("mav0/cam0/sensor.yaml", EurocCameraYaml({camera, vehicle.X_BC()}, scenario_.camera.rate_hz));
  Write("mav0/imu0/data.csv", imu_csv_);
  Write("mav0/imu0/at_rest.csv", at_rest_csv_);
  Write("mav0/imu0/sensor.yaml",
        EurocImuYaml(vehicle.X_BU(), scenario_.imu.rate_hz, scenario_.imu.gyro_noise_rad_s_sqrt_hz,
                     scenario_.imu.accelerometer_noise_m_s2_sqrt_hz));
  Write("mav0/state_groundtruth_estimate0/data.csv", truth_csv);
  Write("camera.yaml", config::CameraInfoYaml(camera, "camera"));
  Write("pad.yaml", runner::PadYaml(scenario_.pad));
  Write("scenario.yaml", runner::ScenarioYaml(scenario_));
}

void FlightRecording::Write(const fs::path& name, const std::string& content) const {
  std::ofstream stream(folder_ / name, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throw WriteError(name);
}

}  // namespace touchdown::datasets
