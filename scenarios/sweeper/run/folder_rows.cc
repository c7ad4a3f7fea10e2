#include "scenarios/sweeper/run/folder_rows.h"

#include "scenarios/sweeper/run/run_sweep.h"

namespace touchdown::sweeper {

FolderRows::FolderRows(const std::filesystem::path& folder, const SweepStore* store) : store_(store) {
  for (FlightRow& row : LeftRows(folder)) left_[row.id] = std::move(row);
}

std::optional<FlightRow> FolderRows::Find(const std::string& id) const {
  std::optional<FlightRow> stored = store_ == nullptr ? std::nullopt : store_->Find(id);
  const auto left = left_.find(id);
  if (left == left_.end()) return stored;
  const bool stays = stored && stored->process == ProcessEnd::kFlown && left->second.process != ProcessEnd::kFlown;
  return stays ? stored : left->second;
}

}  // namespace touchdown::sweeper
