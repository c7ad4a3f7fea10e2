#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// Rows of a sweep's folder: those in its store, and the row files that are not yet collected.
class FolderRows {
 public:
  /// `store` is nullptr when there is none. Throws InputError when a row cannot be read.
  FolderRows(const std::filesystem::path& folder, const SweepStore* store);

  std::optional<FlightRow> Find(const std::string& id) const;

 private:
  const SweepStore* store_;
  std::map<std::string, FlightRow> left_;
};

}  // namespace touchdown::sweeper
