#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/sweeper/run/fly_row.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// A flight to be flown in its own process.
struct FlightTask {
  std::string id = {};
  std::string scenario_yaml = {};
  double limit_s = 0.0;  ///< Limit of the wall-clock time, after which the process is ended.
  int memory_mb = 0;
};

/// Returns the next flight; nullptr while there is none, or when there are no more.
using NextTask = std::function<const FlightTask*()>;
using OnRow = std::function<void(const FlightRow& row)>;

struct ProcessPoolOptions {
  int jobs = 1;
  /// Flies a task in the worker process and writes its row (FlyRow).
  std::function<void(const FlightTask& task)> fly;
};

/// Runs queued flights in worker processes, at most `jobs` concurrently, until `next` returns no more and all have
/// ended. After `stop_requested` no flight starts. `on_row` is called with each row once it is written to `folder`; a
/// process that crashes, hangs or exceeds its memory gets a row with that end. Throws InputError when rows cannot be
/// written; running flights are lost then, and written rows are not.
void FlyTasks(const RowFolder& folder, const ProcessPoolOptions& options, const NextTask& next, const OnRow& on_row,
              const util::StopRequested& stop_requested);

}  // namespace touchdown::sweeper
