#include "scenarios/sweeper/run/boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/error.h"
#include "scenarios/sweeper/analysis/sweep_summary.h"
#include "scenarios/util/program_digest.h"

namespace touchdown::sweeper {
namespace {

double NumberFrom(const SweepParameter& parameter, const std::string& yaml) {
  if (const auto number = AsNumber(yaml)) return *number;
  throw InputError(fmt::format("{}: {}: the values must be numbers for a boundary search; {} is not a number",
                               parameter.location, parameter.key, yaml));
}

std::size_t IndexOf(const SweepFile& file, const std::string& key) {
  const auto found = std::find_if(file.parameters.begin(), file.parameters.end(),
                                  [&](const SweepParameter& parameter) { return parameter.key == key; });
  if (found == file.parameters.end() || !std::holds_alternative<ListedValues>(found->values)) {
    throw InputError(fmt::format("--boundary {}: must be a parameter with listed values", key));
  }
  return static_cast<std::size_t>(found - file.parameters.begin());
}

std::pair<double, double> RangeOf(const SweepParameter& parameter) {
  std::vector<double> numbers;
  for (const std::string& yaml : std::get<ListedValues>(parameter.values).yaml) {
    numbers.push_back(NumberFrom(parameter, yaml));
  }
  const auto [min, max] = std::minmax_element(numbers.begin(), numbers.end());
  if (*min == *max)
    throw InputError(fmt::format("{}: {}: must have at least two different values for a boundary search",
                                 parameter.location, parameter.key));
  return {*min, *max};
}

/// Sweep file with a single value of a parameter and a single seed; other listed parameters have their first value.
SweepFile AtValue(const SweepFile& file, std::size_t parameter, double value, int number) {
  SweepFile single = file;
  single.seeds = {file.seeds.from + number, 1};
  for (SweepParameter& each : single.parameters) {
    if (auto* listed = std::get_if<ListedValues>(&each.values)) listed->yaml.resize(1);
  }
  single.parameters[parameter].values = ListedValues{{fmt::format("{:.6g}", value)}};
  return single;
}

}  // namespace

Boundary FindBoundary(const SweepFile& file, const BoundarySearch& search, const std::filesystem::path& folder,
                      int jobs, const util::StopRequested& stop_requested,
                      const std::function<void(const Boundary&)>& progress) {
  constexpr int kRound = 6;
  if (file.variants.size() > 1) {
    throw InputError(fmt::format("--boundary {}: not allowed for sweep {}, which has variants", search.key, file.name));
  }
  const std::size_t parameter = IndexOf(file, search.key);
  const auto [min, max] = RangeOf(file.parameters[parameter]);
  PassBoundary posterior(min, max, search.pass_rate);
  Boundary boundary{.interval = posterior.boundary()};
  SweepPlan plan;
  SweepFile stored = file;
  stored.criteria.clear();  // Criteria do not apply to flights that concentrate near the boundary.
  stored.parameters[parameter].values = UniformValues{min, max};  // The report treats the values as drawn.
  stored.search = {search.key, min, max, search.pass_rate};
  while (boundary.flights < search.flights) {
    const int round = std::min(kRound, search.flights - boundary.flights);
    for (int i = 0; i < round; ++i) {
      // Values at equal steps of probability: spread out at first, and concentrated near the boundary later.
      const double value = posterior.Quantile((i + 0.5) / round);
      SweepPlan single = PlanSweep(AtValue(file, parameter, value, boundary.flights + i), util::ProgramDigest());
      plan.keys = single.keys;
      single.flights.front().position = boundary.flights + i;
      plan.flights.push_back(std::move(single.flights.front()));
    }
    plan.total = plan.flights.size();
    if (!RunSweep(stored, plan, folder, {.jobs = jobs}, stop_requested, nullptr)) return boundary;
    const std::vector<SweepResult> results = SweepStore(folder, SweepStore::Access::kRead).Results();
    for (int i = 0; i < round; ++i) {
      const SweepResult& result = results.at(static_cast<std::size_t>(boundary.flights + i));
      const bool passed = result.row.passed();
      posterior.Add(NumberFrom(file.parameters[parameter], result.values.at(parameter)), passed ? 1 : 0,
                    passed ? 0 : 1);
    }
    boundary.flights += round;
    boundary.interval = posterior.boundary();
    if (progress) progress(boundary);
    if (boundary.interval.high - boundary.interval.low < search.precision * (max - min)) break;
  }
  boundary.is_done = true;
  return boundary;
}

}  // namespace touchdown::sweeper
