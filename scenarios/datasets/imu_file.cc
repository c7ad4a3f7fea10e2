#include "scenarios/datasets/imu_file.h"

#include "scenarios/util/stamped_csv.h"

namespace touchdown::datasets {

std::vector<ImuReading> ReadImuFile(const std::filesystem::path& file, const models::TimeBase& time) {
  const std::filesystem::path rest_file = file.parent_path() / "at_rest.csv";
  std::vector<util::StampedRow> changes;
  if (std::filesystem::exists(rest_file)) changes = util::ReadStampedCsv(rest_file, 1);

  std::vector<ImuReading> readings;
  bool at_rest = false;
  std::size_t next_change = 0;
  for (const util::StampedRow& row : util::ReadStampedCsv(file, 6)) {
    for (; next_change < changes.size() && changes[next_change].time_ns <= row.time_ns; ++next_change) {
      at_rest = changes[next_change].Number(0) != 0.0;
    }
    readings.push_back({.sample = {.tick = time.FromNanoseconds(row.time_ns),
                                   .specific_force_U = {row.Number(3), row.Number(4), row.Number(5)},
                                   .w_WU_U = {row.Number(0), row.Number(1), row.Number(2)}},
                        .at_rest = at_rest});
  }
  return readings;
}

}  // namespace touchdown::datasets
