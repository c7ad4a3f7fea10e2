#include "scenarios/datasets/euroc_folder.h"

#include "scenarios/datasets/euroc_sensor.h"
#include "scenarios/datasets/flight_metadata.h"
#include "scenarios/datasets/image_folder.h"
#include "scenarios/datasets/imu_file.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

bool Exists(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error);
}

}  // namespace

std::optional<fs::path> FindEurocFolder(const fs::path& input) {
  for (const fs::path& mav0 : {input, input / "mav0", input / "recording" / "mav0"}) {
    if (Exists(mav0 / "cam0" / "data.csv")) return mav0;
  }
  return std::nullopt;
}

EurocFolder::EurocFolder(const fs::path& mav0)
    : mav0_(mav0), frames_(util::ReadStampedCsv(mav0 / "cam0" / "data.csv", 1)) {
  metadata_.frame_order = estimator::FrameOrder::kSequence;
  metadata_.frame_count = frames_.size();
  if (frames_.size() > 1) {
    constexpr double kSecond_ns = 1e9;
    const auto span_ns = static_cast<double>(frames_.back().time_ns - frames_.front().time_ns);
    metadata_.frames_per_s = static_cast<double>(frames_.size() - 1) * kSecond_ns / span_ns;
  }
  const fs::path scenario = fs::weakly_canonical(mav0).parent_path() / "scenario.yaml";
  if (Exists(scenario)) {
    SetFlightMetadata(runner::LoadScenario(scenario), metadata_);
  } else {
    ReadSensors();
  }
  const fs::path imu = mav0 / "imu0" / "data.csv";
  if (Exists(imu)) metadata_.imu = ReadImuFile(imu, metadata_.time);
}

void EurocFolder::ReadSensors() {
  const fs::path camera = mav0_ / "cam0" / "sensor.yaml", imu = mav0_ / "imu0" / "sensor.yaml";
  if (!Exists(camera)) return;
  const EurocCamera sensor = ReadEurocCamera(camera);
  metadata_.camera = sensor.model;
  metadata_.mounting = SensorMounting{.X_BC = sensor.X_BC};
  if (Exists(imu)) metadata_.mounting->X_BU = ReadEurocMounting(imu);
}

std::optional<FootageFrame> EurocFolder::Next() {
  if (next_ == frames_.size()) return std::nullopt;
  const util::StampedRow& row = frames_[next_++];
  return FootageFrame{row.cells.front(), metadata_.time.FromNanoseconds(row.time_ns),
                      ReadGrayImage(mav0_ / "cam0" / "data" / row.cells.front())};
}

}  // namespace touchdown::datasets
