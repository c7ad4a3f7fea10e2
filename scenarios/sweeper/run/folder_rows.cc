#include "scenarios/sweeper/run/folder_rows.h"

#include "scenarios/sweeper/run/run_sweep.h"

namespace touchdown::sweeper {

FolderRows::FolderRows(const std::filesystem::path& folder, const SweepStore* store) : store_(store) {
  for (FlightRow& row : UncollectedRows(folder)) uncollected_[row.id] = std::move(row);
}

std::optional<FlightRow> FolderRows::Find(const std::string& id) const {
  std::optional<FlightRow> stored = store_ == nullptr ? std::nullopt : store_->Find(id);
  const auto found = uncollected_.find(id);
  if (found == uncollected_.end()) return stored;
  const bool is_kept = stored && stored->process == ProcessEnd::kFlown && found->second.process != ProcessEnd::kFlown;
  return is_kept ? stored : found->second;
}

}  // namespace touchdown::sweeper
