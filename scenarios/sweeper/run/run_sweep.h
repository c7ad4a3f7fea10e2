#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/sprt.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// Progress of a sweep.
struct SweepProgress {
  int planned = 0;
  int done = 0;  ///< Completed flights, including those of earlier runs.
  int passed = 0;
  int flying = 0;
  double fraction = 0.0;  ///< Completed fraction of the work, by expected durations.
};

struct SweepOptions {
  int jobs = 1;
  bool retry = false;  ///< Repeats flights whose process crashed, hung or ran out of memory.
};

/// Part `shard` of a plan, 0 to `shards` - 1. The flights of each seed are distributed over the parts in turn. The
/// first part advances by one for each seed, so that every part gets all values and variants.
SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards);

/// Flies the flights of a plan that have no row in the output directory `folder`, and stores each row when its flight
/// ends. Collects existing row files first. The stopping rule of the file ends the sweep early; it uses the flights in
/// the order of the plan, not in the order in which they end. Returns false if a stop was requested before all flights
/// were flown. Throws InputError if `folder` contains something else or cannot be written.
bool RunSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
              const SweepOptions& options, const util::StopRequested& stop_requested,
              const std::function<void(const SweepProgress&)>& progress);

/// Rows of the row files in `folder`, which are not collected yet.
std::vector<FlightRow> UncollectedRows(const std::filesystem::path& folder);

/// Moves the row files in `folder` into the store. Renames a file without a complete row to ID.damaged. Throws
/// InputError if a file cannot be read.
void CollectRows(const std::filesystem::path& folder, SweepStore& store);

}  // namespace touchdown::sweeper
