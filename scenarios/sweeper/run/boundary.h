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

/// Result of a boundary search.
struct Boundary {
  util::Interval interval;  ///< Boundary with its 95 % interval.
  int flights = 0;
  bool is_done = false;  ///< False if a stop was requested before the search ended.
};

/// Finds the value of one parameter at which the pass rate crosses a level. It flies rounds of a few flights at
/// quantiles of the posterior of the boundary (PassBoundary), each with its own seed. Other listed parameters have
/// their first value; the remaining ones are drawn. The flights do not depend on `jobs`, and those with a row in
/// `folder` are not repeated. Throws InputError if the sweep does not list numbers for this parameter or has variants,
/// and as RunSweep does.
Boundary FindBoundary(const SweepFile& file, const BoundarySearch& search, const std::filesystem::path& folder,
                      int jobs, const util::StopRequested& stop_requested,
                      const std::function<void(const Boundary&)>& progress);

}  // namespace touchdown::sweeper
