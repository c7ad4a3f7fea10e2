#pragma once

#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::tests {

/// Results of 20 flights: five seeds, two noise levels and two exposures. With the larger noise and exposure all
/// flights but one fail. The touchdown point of flight n is at x = n mm, y = -1 mm.
inline sweeper::SweepOutcome SyntheticSweep() {
  using namespace sweeper;
  SweepOutcome sweep{
      .spec = {.name = "night <1>",
               .description = "Noise & exposure.",
               .axes = {{"camera.noise_sigma", {"10", "2"}}, {"camera.exposure_ms", {"4", "8"}}, {"start.yaw_deg", {}}},
               .criteria = {{.metric = "pass_rate", .min = 0.9},
                            {.metric = "flight.touchdown_xy_error_m", .quantile = 0.5, .max = 0.05}}},
      .planned = 23,
      .total = 23,
      .stale = 7};
  for (int seed = 1; seed <= 5; ++seed) {
    for (const char* noise : {"10", "2"}) {
      for (const char* exposure : {"4", "8"}) {
        const auto n = static_cast<double>(sweep.results.size() + 1);
        const bool failed = noise == std::string("10") && exposure == std::string("8") && seed > 1;
        sweep.results.push_back({.seed = static_cast<std::uint64_t>(seed),
                                 .values = {noise, exposure, std::to_string(seed) + ".5"},
                                 .row = {.id = "id" + std::to_string(sweep.results.size() + 1),
                                         .process = ProcessEnd::kFlown,
                                         .verdict = failed ? runner::Verdict::kFail : runner::Verdict::kPass,
                                         .outcome = failed ? runner::Outcome::kGaveUp : runner::Outcome::kLanded,
                                         .reason = failed ? "the pad was <lost>" : "",
                                         .failed_check = failed ? "outcome" : "",
                                         .failed_phase = failed ? "blind_descent" : "",
                                         .metrics = {{"flight.touchdown_xy_error_m", n / 1000.0},
                                                     {"flight.touchdown_x_m", n / 1000.0},
                                                     {"flight.touchdown_y_m", -0.001}},
                                         .scenario = "pad: {outer_radius_m: 0.08, ring_width_m: 0.01}\n"
                                                     "script: [{do: land}]\nstart: {airborne: true}\n"}});
      }
    }
  }
  FlightRow& crashed = sweep.results.back().row;
  crashed.process = ProcessEnd::kOutOfMemory;
  crashed.verdict = runner::Verdict::kError;
  crashed.outcome = runner::Outcome::kError;
  crashed.reason = "exceeded the memory limit";
  crashed.stderr_tail = "std::bad_alloc </pre>";
  crashed.metrics.clear();
  return sweep;
}

}  // namespace touchdown::tests
