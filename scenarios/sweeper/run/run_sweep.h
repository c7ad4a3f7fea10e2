#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/sweeper/analysis/sprt.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// How far a sweep is.
struct SweepProgress {
  int planned = 0;
  int done = 0;  ///< Of the planned ones, those that were there already among them.
  int passed = 0;
  int flying = 0;
  double share = 0.0;  ///< Of the whole work, by the flights' expected lengths.
};

struct SweepOptions {
  int jobs = 1;
  bool retry = false;  ///< Flies those again whose process crashed, hung or ran out of memory.
};

/// The part of number `shard`, from 0, of as many: the flights of each seed are dealt to the parts in turn, those of
/// the next seed from the next part on, so that every part gets each value and variant.
SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards);

/// Flies what is yet to be flown of a plan, into `folder`, and keeps every row as soon as it is there. Rows that an
/// ended program left are taken in first. `stop` ends it sooner, decided by the flights in the plan's order, whatever
/// the order in which they are done. Returns false when a stop was requested before all was flown. Throws InputError
/// when the folder is another's, or cannot be written.
bool RunSweep(const SweepFile& file, const SweepPlan& plan, const std::filesystem::path& folder,
              const SweepOptions& options, const util::StopRequested& stop_requested,
              const std::function<void(const SweepProgress&)>& progress);

/// The rows that processes left in `folder`, as they lie there.
std::vector<FlightRow> LeftRows(const std::filesystem::path& folder);

/// Takes the rows that processes left in `folder` into the store, and removes their files. What is no whole row is kept
/// as ID.damaged. Throws InputError when one cannot be read.
void TakeInRows(const std::filesystem::path& folder, SweepStore& store);

}  // namespace touchdown::sweeper
