#include "scenarios/sweeper/analysis/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>

#include "models/error.h"
#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

constexpr double kUpper = 0.975;  // Upper quantile of a two-sided 95 % interval.
constexpr double kPower = 0.8;

using Pair = std::pair<const SweepResult*, const SweepResult*>;
using PairsBySeed = std::map<std::uint64_t, std::vector<Pair>>;

/// Key by which the flights of two sweeps are paired.
using Identity = std::tuple<std::uint64_t, std::string, std::map<std::string, std::string>>;

Identity IdentityOf(const SweepResult& result, const std::vector<std::string>& keys) {
  std::map<std::string, std::string> values;
  for (std::size_t i = 0; i < keys.size(); ++i) values[keys[i]] = result.values[i];
  return {result.seed, result.variant, std::move(values)};
}

std::map<Identity, const SweepResult*> ByIdentity(const StoredResults& stored) {
  std::map<Identity, const SweepResult*> found;
  for (const SweepResult& result : stored.results) found[IdentityOf(result, stored.keys)] = &result;
  return found;
}

PairsBySeed PairsOf(const StoredResults& a, const StoredResults& b, Comparison& comparison) {
  const auto in_a = ByIdentity(a), in_b = ByIdentity(b);
  PairsBySeed pairs;
  comparison.only_b = static_cast<int>(in_b.size());
  for (const auto& [identity, result] : in_a) {
    const auto found = in_b.find(identity);
    if (found == in_b.end()) {
      ++comparison.only_a;
    } else {
      pairs[result->seed].emplace_back(result, found->second);
      --comparison.only_b;
    }
  }
  return pairs;
}

/// Difference of two paired proportions with the interval of Bonett and Price (2012), which adds one change in each
/// direction. `gained` and `lost` are the numbers of seeds that pass only in B and only in A.
util::Interval ProportionDifference(double gained, double lost, double seeds) {
  const double n = seeds + 2.0, up = (gained + 1.0) / n, down = (lost + 1.0) / n;
  const double half = util::NormalQuantile(kUpper) * std::sqrt((up + down - (up - down) * (up - down)) / n);
  return {(gained - lost) / seeds, std::max(-1.0, up - down - half), std::min(1.0, up - down + half)};
}

/// Smallest worsening of a pass rate that the seeds detect with 80 % power, if `both_ways` of them change in each
/// direction in any case. The number of changes for the worse is binomial. Returns 1 if the seeds are too few to detect
/// any change.
double MinDetectableChange(int both_ways, int seeds) {
  int needed = both_ways + 1;  // Fewest changes for the worse that are significant.
  while (needed + both_ways <= seeds && ProportionDifference(both_ways, needed, seeds).high >= 0.0) ++needed;
  if (needed + both_ways > seeds) return 1.0;
  double low = 0.0, high = 1.0;  // Bisection: the power is too low at `low`, and sufficient at `high`.
  for (int i = 0; i < 40; ++i) {
    const double probability = 0.5 * (low + high);
    (util::BinomialTail(needed, seeds, probability) < kPower ? low : high) = probability;
  }
  return high - static_cast<double>(both_ways) / seeds;
}

PairedDifference PassRateDifference(const PairsBySeed& pairs_by_seed) {
  PairedDifference difference{
      .name = std::string(kPassRate), .seeds = static_cast<int>(pairs_by_seed.size()), .larger_is_better = true};
  double gained = 0.0, lost = 0.0;
  for (const auto& [seed, pairs] : pairs_by_seed) {
    const double weight = 1.0 / static_cast<double>(pairs.size());
    for (const auto& [a, b] : pairs) {
      difference.a += a->row.passed() ? weight : 0.0;
      difference.b += b->row.passed() ? weight : 0.0;
      gained += !a->row.passed() && b->row.passed() ? weight : 0.0;
      lost += a->row.passed() && !b->row.passed() ? weight : 0.0;
    }
    difference.pairs += static_cast<int>(pairs.size());
  }
  difference.a /= difference.seeds;
  difference.b /= difference.seeds;
  difference.difference = ProportionDifference(gained, lost, difference.seeds);
  difference.min_detectable_difference =
      MinDetectableChange(static_cast<int>(std::ceil(std::min(gained, lost))), difference.seeds);
  return difference;
}

std::optional<PairedDifference> MetricDifference(const runner::MetricInfo& metric, const PairsBySeed& pairs_by_seed) {
  int count = 0;
  std::vector<double> a_means, b_means, differences;  // One value per seed.
  for (const auto& [seed, pairs] : pairs_by_seed) {
    std::vector<double> a_values, b_values;
    for (const auto& [a, b] : pairs) {
      const auto in_a = a->row.metrics.find(metric.name), in_b = b->row.metrics.find(metric.name);
      if (in_a == a->row.metrics.end() || in_b == b->row.metrics.end()) continue;
      a_values.push_back(in_a->second);
      b_values.push_back(in_b->second);
    }
    if (a_values.empty()) continue;
    count += static_cast<int>(a_values.size());
    a_means.push_back(util::Mean(a_values));
    b_means.push_back(util::Mean(b_values));
    differences.push_back(b_means.back() - a_means.back());
  }
  constexpr std::size_t kFewest = 2;
  if (differences.size() < kFewest) return std::nullopt;
  const auto n = static_cast<double>(differences.size());
  const int freedom = static_cast<int>(differences.size()) - 1;
  const double standard_error = util::StandardDeviation(differences) / std::sqrt(n);
  return PairedDifference{
      .name = std::string(metric.name),
      .unit = std::string(metric.unit),
      .pairs = count,
      .seeds = static_cast<int>(differences.size()),
      .a = util::Mean(a_means),
      .b = util::Mean(b_means),
      .difference = util::MeanInterval(differences),
      .min_detectable_difference =
          (util::StudentsTQuantile(kUpper, freedom) + util::StudentsTQuantile(kPower, freedom)) * standard_error,
      .larger_is_better = metric.larger_is_better};
}

/// Decides whether a difference is a worsening. Only the pass rate and metrics with a margin are judged.
void Judge(PairedDifference& difference, const std::vector<Margin>& margins) {
  const auto found = std::find_if(margins.begin(), margins.end(),
                                  [&](const Margin& margin) { return margin.name == difference.name; });
  if (found == margins.end() && difference.name != kPassRate) return;
  difference.margin = found == margins.end() ? 0.0 : found->margin;
  const double sign = difference.larger_is_better ? -1.0 : 1.0;
  const double smallest_worsening = std::min(sign * difference.difference.low, sign * difference.difference.high);
  difference.is_worse = smallest_worsening > 0.0 && sign * difference.difference.value > difference.margin;
}

void CheckMargins(const std::vector<Margin>& margins) {
  for (const Margin& margin : margins) {
    if (margin.name != kPassRate && runner::FindMetric(margin.name) == nullptr) {
      throw InputError(fmt::format("--margin: unknown metric {}", margin.name));
    }
    if (margin.name == kPassRate && margin.margin >= 1.0) {
      throw InputError(fmt::format("--margin pass_rate={:g}: must be below 1", margin.margin));
    }
  }
}

/// Throws InputError for a margin of a quantity that was not compared, because such a comparison must not pass.
void RejectUnjudgedMargin(const Margin& margin, const Comparison& comparison) {
  const bool is_judged = std::any_of(comparison.differences.begin(), comparison.differences.end(),
                                     [&](const PairedDifference& each) { return each.name == margin.name; });
  if (!is_judged)
    throw InputError(fmt::format("--margin {}: fewer than two seeds have pairs with this metric", margin.name));
}

}  // namespace

bool Comparison::is_worse() const {
  return std::any_of(differences.begin(), differences.end(), [](const PairedDifference& d) { return d.is_worse; });
}

StoredResults LoadResults(const std::string& source) {
  if (fs::is_directory(source)) {
    const SweepStore store(source, SweepStore::Access::kRead);
    return {source, store.spec().keys(), store.Results()};
  }
  return ReadRowsCsv(source);
}

StoredResults OfVariant(const StoredResults& stored, const std::string& variant) {
  StoredResults part{.source = stored.source, .keys = stored.keys, .results = {}};
  for (const SweepResult& result : stored.results) {
    if (result.variant != variant) continue;
    part.results.push_back(result);
    part.results.back().variant.clear();
  }
  if (part.results.empty())
    throw InputError(fmt::format("{}: contains no flights of variant {}", stored.source, variant));
  return part;
}

Comparison Compare(const StoredResults& a, const StoredResults& b, const std::vector<Margin>& margins) {
  CheckMargins(margins);
  Comparison comparison;
  const PairsBySeed pairs = PairsOf(a, b, comparison);
  if (pairs.empty()) {
    throw InputError(
        fmt::format("{} and {}: no flights with the same seed, variant and parameters", a.source, b.source));
  }
  comparison.differences.push_back(PassRateDifference(pairs));
  for (const runner::MetricInfo& metric : runner::AllMetrics()) {
    if (const auto difference = MetricDifference(metric, pairs)) comparison.differences.push_back(*difference);
  }
  for (PairedDifference& difference : comparison.differences) Judge(difference, margins);
  for (const Margin& margin : margins) RejectUnjudgedMargin(margin, comparison);
  return comparison;
}

}  // namespace touchdown::sweeper
