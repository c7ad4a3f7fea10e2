#pragma once

#include <filesystem>
#include <optional>

#include "scenarios/datasets/footage.h"
#include "scenarios/util/stamped_csv.h"

namespace touchdown::datasets {

/// Finds the directory mav0 of a recording in the EuRoC layout: `input`, `input`/mav0 or `input`/recording/mav0.
/// Returns nullopt when there is none.
std::optional<std::filesystem::path> FindEurocFolder(const std::filesystem::path& input);

/// Reads a recording in the layout of the EuRoC data sets (Burri et al.: The EuRoC micro aerial vehicle datasets, IJRR
/// 35(10), 2016): the images of cam0 and, when present, its sensor.yaml and imu0.
///
/// The recording of a flight has a scenario.yaml next to mav0. Then all estimator inputs are bit-identical to those of
/// the flight.
class EurocFolder final : public Footage {
 public:
  /// Throws InputError, naming file and line, for files that do not follow the layout.
  explicit EurocFolder(const std::filesystem::path& mav0);

  const FootageMetadata& metadata() const override { return metadata_; }
  std::optional<FootageFrame> Next() override;

 private:
  void ReadSensors();

  std::filesystem::path mav0_;
  FootageMetadata metadata_;
  std::vector<util::StampedRow> frames_;
  std::size_t next_ = 0;
};

}  // namespace touchdown::datasets
