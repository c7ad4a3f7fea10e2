#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "scenarios/sweeper/plan/sweep_store.h"

namespace touchdown::sweeper {

/// Rows of a sweep: those in its database, and the row files that are not collected yet.
class FolderRows {
 public:
  /// `store` may be nullptr, and must outlive this object otherwise. Throws InputError if a row file cannot be read.
  FolderRows(const std::filesystem::path& folder, const SweepStore* store);

  /// Row of a flight as it will be after the row files are collected; nullopt if there is none.
  std::optional<FlightRow> Find(const std::string& id) const;

 private:
  const SweepStore* store_;
  std::map<std::string, FlightRow> uncollected_;
};

}  // namespace touchdown::sweeper
