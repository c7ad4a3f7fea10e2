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
  throw InputError(
      fmt::format("{}: {}: a boundary search needs numbers, {} is not one", parameter.place, parameter.key, yaml));
}

std::size_t IndexOf(const SweepFile& file, const std::string& key) {
  const auto found = std::find_if(file.parameters.begin(), file.parameters.end(),
                                  [&](const SweepParameter& parameter) { return parameter.key == key; });
  if (found == file.parameters.end() || !std::holds_alternative<ListedValues>(found->values)) {
    throw InputError(fmt::format("--boundary {}: the sweep lists no values of it", key));
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
    throw InputError(fmt::format("{}: {}: needs two values for a boundary", parameter.place, parameter.key));
  return {*min, *max};
}

/// The flights of one value, with a seed of its own.
SweepFile AtValue(const SweepFile& file, std::size_t parameter, double value, int number) {
  SweepFile one = file;
  one.seeds = {file.seeds.from + number, 1};
  for (SweepParameter& each : one.parameters) {
    if (auto* listed = std::get_if<ListedValues>(&each.values)) listed->yaml.resize(1);
  }
  one.parameters[parameter].values = ListedValues{{fmt::format("{:.6g}", value)}};
  return one;
}

}  // namespace

Boundary FindBoundary(const SweepFile& file, const BoundarySearch& search, const std::filesystem::path& folder,
                      int jobs, const util::StopRequested& stop_requested,
                      const std::function<void(const Boundary&)>& progress) {
  constexpr int kRound = 6;
  if (file.variants.size() > 1) {
    throw InputError(
        fmt::format("--boundary {}: sweep {} has variants, and each has a boundary of its own", search.key, file.name));
  }
  const std::size_t parameter = IndexOf(file, search.key);
  const auto [min, max] = RangeOf(file.parameters[parameter]);
  PassBoundary posterior(min, max, search.pass_rate);
  Boundary boundary{.edge = posterior.edge()};
  SweepPlan plan;
  SweepFile whole = file;
  whole.criteria.clear();  // They are not meant of flights that gather where half of them fail.
  whole.parameters[parameter].values = UniformValues{min, max};  // On its page: not listed, but met here and there.
  whole.search = {search.key, min, max, search.pass_rate};
  while (boundary.flights < search.flights) {
    const int round = std::min(kRound, search.flights - boundary.flights);
    for (int i = 0; i < round; ++i) {
      // Spread over the posterior, evenly in probability: wide at first, closing in.
      const double value = posterior.Quantile((i + 0.5) / round);
      SweepPlan one = PlanSweep(AtValue(file, parameter, value, boundary.flights + i), util::ProgramDigest());
      plan.keys = one.keys;
      one.flights.front().position = boundary.flights + i;
      plan.flights.push_back(std::move(one.flights.front()));
    }
    plan.whole = plan.flights.size();
    if (!RunSweep(whole, plan, folder, {.jobs = jobs}, stop_requested, nullptr)) return boundary;
    const std::vector<SweepResult> results = SweepStore(folder, SweepStore::Access::kRead).Results();
    for (int i = 0; i < round; ++i) {
      const SweepResult& result = results.at(static_cast<std::size_t>(boundary.flights + i));
      const bool passed = result.row.passed();
      posterior.Take(NumberFrom(file.parameters[parameter], result.values.at(parameter)), passed ? 1 : 0,
                     passed ? 0 : 1);
    }
    boundary.flights += round;
    boundary.edge = posterior.edge();
    if (progress) progress(boundary);
    if (boundary.edge.high - boundary.edge.low < search.precision * (max - min)) break;
  }
  boundary.is_done = true;
  return boundary;
}

}  // namespace touchdown::sweeper
