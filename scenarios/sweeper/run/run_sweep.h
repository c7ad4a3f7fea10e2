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
  int done = 0;  ///< Flights that are done, including those of earlier runs.
  int passed = 0;
  int flying = 0;
  double share = 0.0;  ///< Fraction of the work that is done, by expected durations.
};

struct SweepOptions {
  int jobs = 1;
  bool retry = false;  ///< Repeats flights whose process crashed, hung or ran out of memory.
};

/// Part number `shard` (from 0) of `count` parts of a plan. The flights of each seed are distributed over the parts in
/// turn, starting one part further for each seed, so that every part gets each value and variant.
SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards);

/// Flies the missing flights of a plan into `folder`, and stores every row at once. Row files of earlier programs are
/// collected first. `stop` ends the sweep early; it is decided by the flights in the order of the plan, whatever the
/// order in which they end. Returns false when a stop was requested before all flights were flown. Throws InputError
/// when the folder belongs to something else or cannot be written.
bool RunSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
              const SweepOptions& options, const util::StopRequested& stop_requested,
              const std::function<void(const SweepProgress&)>& progress);

/// Row files in `folder`.
std::vector<FlightRow> LeftRows(const std::filesystem::path& folder);

/// Moves the row files in `folder` into the store. A file without a complete row is renamed to ID.damaged. Throws
/// InputError when one cannot be read.
void TakeInRows(const std::filesystem::path& folder, SweepStore& store);

}  // namespace touchdown::sweeper
