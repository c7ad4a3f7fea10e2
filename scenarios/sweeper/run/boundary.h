#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "scenarios/sweeper/analysis/pass_boundary.h"
#include "scenarios/sweeper/run/run_sweep.h"

namespace touchdown::sweeper {

/// Settings of a boundary search.
struct BoundarySearch {
  std::string key;  ///< Key of a parameter that lists numbers. The search is between the smallest and the largest.
  double pass_rate = 0.5;   ///< Pass rate at the boundary.
  int flights = 60;         ///< Largest number of flights.
  double precision = 0.05;  ///< The search ends when the interval is narrower than this fraction of the range.
};

struct Boundary {
  util::Interval edge;
  int flights = 0;
  bool is_done = false;  ///< false: a stop was requested.
};

/// Finds the value of one parameter at which the pass rate crosses a level, in rounds of a few flights near the
/// boundary of the posterior (PassBoundary), each flight with its own seed. All other parameters have their first
/// listed value, or are drawn. The flights do not depend on `jobs`; those that are already in `folder` are not
/// repeated. Throws InputError when the sweep lists no such parameter or has variants, and as RunSweep does.
Boundary FindBoundary(const SweepFile& file, const BoundarySearch& search, const std::filesystem::path& folder,
                      int jobs, const util::StopRequested& stop_requested,
                      const std::function<void(const Boundary&)>& progress);

}  // namespace touchdown::sweeper
