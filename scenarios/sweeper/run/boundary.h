#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "scenarios/sweeper/analysis/pass_edge.h"
#include "scenarios/sweeper/run/run_sweep.h"

namespace touchdown::sweeper {

/// What to look for.
struct BoundarySearch {
  std::string key;          ///< Of a parameter that lists numbers: between the least and the largest it is sought.
  double pass_rate = 0.5;   ///< Where the rate goes through this.
  int flights = 60;         ///< At most.
  double precision = 0.05;  ///< Of the range: ends when the interval is narrower.
};

struct Boundary {
  util::Interval edge;
  int flights = 0;
  bool is_done = false;  ///< false: a stop was requested.
};

/// Finds the value of one parameter at which the pass rate goes through a level, in rounds of a few flights where the
/// posterior (PassBoundary) has the edge, each flight with a seed of its own. All other parameters keep to their first
/// listed value, or are drawn. The rounds do not depend on `jobs`, so that the same flights are flown; those that are
/// in `folder` already are not flown again. Throws InputError when the sweep lists no such parameter or has variants,
/// and as RunSweep does.
Boundary FindBoundary(const SweepFile& file, const BoundarySearch& search, const std::filesystem::path& folder,
                      int jobs, const util::StopRequested& stop_requested,
                      const std::function<void(const Boundary&)>& progress);

}  // namespace touchdown::sweeper
