#pragma once

#include <filesystem>
#include <optional>

#include "scenarios/datasets/footage.h"
#include "scenarios/util/stamped_csv.h"

namespace touchdown::datasets {

/// The folder mav0 of a recording in EuRoC's layout: `input` itself, or within `input` or its folder `recording`;
/// nullopt when there is none.
std::optional<std::filesystem::path> FindEurocFolder(const std::filesystem::path& input);

/// A recording in the layout of the EuRoC data sets (Burri et al.: The EuRoC micro aerial vehicle datasets, IJRR
/// 35(10), 2016): cam0 with its pictures and, where they are there, its sensor.yaml and imu0.
///
/// Beside mav0, a recording of a flight holds its scenario.yaml: all that the flight's estimator was told is then as in
/// the flight, to the last bit.
class EurocFolder final : public Footage {
 public:
  /// Throws InputError, naming file and line, for files that are not of the layout.
  explicit EurocFolder(const std::filesystem::path& mav0);

  const FootageFacts& facts() const override { return facts_; }
  std::optional<FootageFrame> Next() override;

 private:
  void ReadSensors();

  std::filesystem::path mav0_;
  FootageFacts facts_;
  std::vector<util::StampedRow> frames_;
  std::size_t next_ = 0;
};

}  // namespace touchdown::datasets
