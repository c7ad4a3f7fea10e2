#include "scenarios/report/flight_files.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include "models/error.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> TextOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return stream.bad() || !stream.is_open() ? std::nullopt : std::optional(std::move(text));
}

std::string Read(const fs::path& file) {
  std::optional<std::string> text = TextOf(file);
  if (!text) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return *std::move(text);
}

}  // namespace

FlightFiles ReadFlightFiles(const fs::path& folder) {
  const std::optional<std::string> result = TextOf(folder / "result.json");
  if (!result || result->find(kFlightMark) == std::string::npos) {
    throw InputError(fmt::format("{}: is no flight's folder (it has no result.json of a flight)", folder.string()));
  }
  FlightFiles files;
  files.folder = folder;
  files.result_json = *result;
  files.scenario_yaml = Read(folder / "scenario.yaml");
  files.flight_csv = Read(folder / "flight.csv");
  files.frames_csv = Read(folder / "frames.csv");
  files.frame_timing_csv = Read(folder / "frame_timing.csv");
  files.timing_json = Read(folder / "timing.json");
  files.has_video = fs::is_regular_file(folder / "flight.mp4");
  return files;
}

}  // namespace touchdown::report
