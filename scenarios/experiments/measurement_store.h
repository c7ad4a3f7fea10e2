#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/experiments/measurement.h"

namespace touchdown::experiments {

/// A folder in which each measurement that is done has a file: a run that was stopped continues from there. A file that
/// another build or another plan left, told by its `origin`, does not count, and is replaced.
class MeasurementStore {
 public:
  /// Makes the folder. Throws InputError when it cannot.
  MeasurementStore(std::filesystem::path folder, std::string origin);

  /// nullopt when it is yet to be measured.
  std::optional<Json> Find(const std::string& id) const;

  /// Where it was measured: what PlatformFacts told then; empty when it is yet to be measured.
  std::vector<std::pair<std::string, std::string>> PlatformOf(const std::string& id) const;

  /// The file is there whole or not at all. Throws InputError when it cannot be written. Different ids may be written
  /// from different threads at once.
  void Put(const std::string& id, const Json& value) const;

 private:
  std::optional<Json> Read(const std::string& id) const;
  std::filesystem::path FileOf(const std::string& id) const { return folder_ / (id + ".json"); }

  std::filesystem::path folder_;
  std::string origin_;
};

}  // namespace touchdown::experiments
