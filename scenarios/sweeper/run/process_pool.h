#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenarios/sweeper/run/fly_row.h"
#include "scenarios/util/interrupted.h"

namespace touchdown::sweeper {

/// A flight for a process of its own.
struct FlightTask {
  std::string id = {};
  std::string scenario_yaml = {};
  double limit_s = 0.0;  ///< By the wall clock; beyond it the process is ended.
  int memory_mb = 0;
};

/// The next flight that is wanted; nullptr while there is none, or when there are no more.
using NextTask = std::function<const FlightTask*()>;
using OnRow = std::function<void(const FlightRow& row)>;

struct ProcessPoolOptions {
  int jobs = 1;
  /// Flies a task, in a process of its own, and leaves its row: see FlyRow.
  std::function<void(const FlightTask& task)> fly;
};

/// Flies what `next` wants, so many at a time, each in a process of its own, until it wants no more and all have
/// landed; once `stop_requested`, no further one begins. Each flight becomes a row, which `on_row` is given when it is
/// left in `folder`: of a process that crashes, hangs or is ended for its memory, one that says so. Throws InputError
/// when rows cannot be written; the flights of the other processes are lost then, and what was left before is not.
void FlyTasks(const RowFolder& folder, const ProcessPoolOptions& options, const NextTask& next, const OnRow& on_row,
              const util::StopRequested& stop_requested);

}  // namespace touchdown::sweeper
