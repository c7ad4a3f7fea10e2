#pragma once

#include <filesystem>
#include <string>

namespace touchdown::report {

/// Signature that identifies the result.json of a flight.
inline constexpr char kFlightSignature[] = "\"log_sha256\"";

/// Contents of the files in a flight directory from which the report page is built.
struct FlightFiles {
  std::filesystem::path folder;  ///< For error messages.
  std::string result_json;
  std::string scenario_yaml;
  std::string flight_csv;
  std::string frames_csv;
  std::string frame_timing_csv;
  std::string timing_json;
  bool has_video = false;  ///< Whether flight.mp4 exists.

  /// Path of a file of the flight directory, for error messages.
  std::string NameOf(std::string_view file) const { return (folder / file).string(); }
};

/// Reads the files of a flight directory. Throws InputError when `folder` is not a flight directory or a file cannot be
/// read.
FlightFiles ReadFlightFiles(const std::filesystem::path& folder);

}  // namespace touchdown::report
