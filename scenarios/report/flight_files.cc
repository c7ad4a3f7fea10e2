#include "scenarios/report/flight_files.h"

#include <fmt/format.h>

#include <optional>

#include "models/error.h"
#include "scenarios/util/file.h"

namespace touchdown::report {

namespace fs = std::filesystem;

FlightFiles ReadFlightFiles(const fs::path& folder) {
  const std::optional<std::string> result = util::ReadTextFileIfPresent(folder / "result.json");
  if (!result || result->find(kFlightSignature) == std::string::npos) {
    throw InputError(fmt::format("{}: not a flight directory: it has no result.json of a flight", folder.string()));
  }
  FlightFiles files;
  files.folder = folder;
  files.result_json = *result;
  files.scenario_yaml = util::ReadTextFile(folder / "scenario.yaml");
  files.flight_csv = util::ReadTextFile(folder / "flight.csv");
  files.frames_csv = util::ReadTextFile(folder / "frames.csv");
  files.frame_timing_csv = util::ReadTextFile(folder / "frame_timing.csv");
  files.timing_json = util::ReadTextFile(folder / "timing.json");
  files.has_video = fs::is_regular_file(folder / "flight.mp4");
  return files;
}

}  // namespace touchdown::report
