#pragma once

#include <filesystem>
#include <string>

namespace touchdown::report {

/// What result.json of a flight, and of nothing else, holds.
inline constexpr char kFlightSignature[] = "\"log_sha256\"";

/// The texts of a flight's folder that its page is made of.
struct FlightFiles {
  std::filesystem::path folder;  ///< For messages.
  std::string result_json;
  std::string scenario_yaml;
  std::string flight_csv;
  std::string frames_csv;
  std::string frame_timing_csv;
  std::string timing_json;
  bool has_video = false;  ///< Whether flight.mp4 is there.

  /// How messages call one of them.
  std::string NameOf(std::string_view file) const { return (folder / file).string(); }
};

/// Reads them. Throws InputError when `folder` is no flight's folder, or a file cannot be read.
FlightFiles ReadFlightFiles(const std::filesystem::path& folder);

}  // namespace touchdown::report
