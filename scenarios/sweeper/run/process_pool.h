#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/sweeper/run/fly_row.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// A flight to fly in its own process.
struct FlightTask {
  std::string id = {};
  std::string scenario_yaml = {};
  double limit_s = 0.0;  ///< Elapsed time after which the process is killed.
  int memory_mb = 0;     ///< Limit of the address space; 0: no limit.
};

/// Returns the next flight; nullptr if there is none.
using NextTask = std::function<const FlightTask*()>;
using OnRow = std::function<void(const FlightRow& row)>;

struct ProcessPoolOptions {
  int jobs = 1;
  /// Flies a task in the worker process and writes its row (FlyRow).
  std::function<void(const FlightTask& task)> fly;
};

/// Runs queued flights in worker processes, at most `jobs` concurrently, until `next` returns no more and all have
/// ended. After a stop request, no flight starts. Calls `on_row` with each row after it is written to `folder`. If a
/// process crashes, hangs or exceeds its memory limit, its row reports this end. Throws InputError if rows cannot be
/// written; running flights are then lost, and written rows are kept.
void FlyTasks(const RowFolder& folder, const ProcessPoolOptions& options, const NextTask& next, const OnRow& on_row,
              const util::StopRequested& stop_requested);

}  // namespace touchdown::sweeper
