#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/experiments/measurement.h"

namespace touchdown::experiments {

/// Directory with one file for each completed measurement, from which an interrupted run resumes. Files with another
/// `origin`, which come from another build or plan, are ignored and replaced.
class MeasurementStore {
 public:
  /// Creates the directory. Throws InputError on failure.
  MeasurementStore(std::filesystem::path folder, std::string origin);

  /// The stored result, or nullopt if it is not measured yet.
  std::optional<Json> Find(const std::string& id) const;

  /// PlatformFacts() of the computer on which it was measured; empty if it is not measured yet.
  std::vector<std::pair<std::string, std::string>> PlatformOf(const std::string& id) const;

  /// Stores a result atomically. Throws InputError when the file cannot be written. Threads may store different ids
  /// concurrently.
  void Put(const std::string& id, const Json& value) const;

 private:
  std::optional<Json> Read(const std::string& id) const;
  std::filesystem::path FileOf(const std::string& id) const { return folder_ / (id + ".json"); }

  std::filesystem::path folder_;
  std::string origin_;
};

}  // namespace touchdown::experiments
