#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// The rows that count in a sweep's folder: those of its store, and those that lie beside it, as if they were taken in.
class FolderRows {
 public:
  /// `store` is nullptr while there is none. Throws InputError when a row cannot be read.
  FolderRows(const std::filesystem::path& folder, const SweepStore* store);

  std::optional<FlightRow> Find(const std::string& id) const;

 private:
  const SweepStore* store_;
  std::map<std::string, FlightRow> left_;
};

}  // namespace touchdown::sweeper
