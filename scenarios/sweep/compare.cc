#include "scenarios/sweep/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>

#include "models/error.h"
#include "scenarios/sweep/sweep_file.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr double kUpper = 0.975;  // Of a two-sided interval of 95 %.
constexpr double kPower = 0.8;

using Pair = std::pair<const SweepResult*, const SweepResult*>;

/// What two sweeps' flights are paired by.
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

std::vector<Pair> PairsOf(const StoredResults& a, const StoredResults& b, Comparison& comparison) {
  const auto in_a = ByIdentity(a), in_b = ByIdentity(b);
  std::vector<Pair> pairs;
  for (const auto& [identity, result] : in_a) {
    const auto found = in_b.find(identity);
    if (found == in_b.end()) {
      ++comparison.only_a;
    } else {
      pairs.emplace_back(result, found->second);
    }
  }
  comparison.only_b = static_cast<int>(in_b.size() - pairs.size());
  return pairs;
}

/// By Bonett and Price 2012, of `gained` and `lost` passes: as if one pair more had changed each way.
Interval ShareDifference(double gained, double lost, double n) {
  const double up = (gained + 1.0) / (n + 2.0), down = (lost + 1.0) / (n + 2.0);
  const double half = NormalQuantile(kUpper) * std::sqrt((up + down - (up - down) * (up - down)) / (n + 2.0));
  return {(gained - lost) / n, std::max(-1.0, up - down - half), std::min(1.0, up - down + half)};
}

/// The smallest change of a pass rate that pairs show with 80 % chance, when `both_ways` of them change in each
/// direction anyway: so many more must change in one of them, and do so by a binomial's chance. 1 when no change of so
/// few pairs shows.
double ResolvableChange(int both_ways, int pairs) {
  int needed = both_ways + 1;
  while (needed + both_ways <= pairs && ShareDifference(both_ways, needed, pairs).high >= 0.0) ++needed;
  if (needed + both_ways > pairs) return 1.0;
  double too_rare = 0.0, enough = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double chance = 0.5 * (too_rare + enough);
    (ChanceOfAtLeast(needed, pairs, chance) < kPower ? too_rare : enough) = chance;
  }
  return enough - static_cast<double>(both_ways) / pairs;
}

PairedDifference PassRateDifference(const std::vector<Pair>& pairs) {
  PairedDifference difference{
      .name = std::string(kPassRate), .pairs = static_cast<int>(pairs.size()), .larger_is_better = true};
  int gained = 0, lost = 0;
  for (const auto& [a, b] : pairs) {
    difference.a += a->row.passed() ? 1.0 : 0.0;
    difference.b += b->row.passed() ? 1.0 : 0.0;
    gained += !a->row.passed() && b->row.passed() ? 1 : 0;
    lost += a->row.passed() && !b->row.passed() ? 1 : 0;
  }
  const auto n = static_cast<double>(pairs.size());
  difference.a /= n;
  difference.b /= n;
  difference.difference = ShareDifference(gained, lost, n);
  difference.resolvable = ResolvableChange(std::min(gained, lost), difference.pairs);
  return difference;
}

std::optional<PairedDifference> MetricDifference(const MetricInfo& metric, const std::vector<Pair>& pairs) {
  std::vector<double> of_a, of_b, differences;
  for (const auto& [a, b] : pairs) {
    const auto in_a = a->row.metrics.find(metric.name), in_b = b->row.metrics.find(metric.name);
    if (in_a == a->row.metrics.end() || in_b == b->row.metrics.end()) continue;
    of_a.push_back(in_a->second);
    of_b.push_back(in_b->second);
    differences.push_back(in_b->second - in_a->second);
  }
  constexpr std::size_t kFewest = 2;
  if (differences.size() < kFewest) return std::nullopt;
  const auto n = static_cast<double>(differences.size());
  const int freedom = static_cast<int>(differences.size()) - 1;
  const double standard_error = StandardDeviation(differences) / std::sqrt(n);
  return PairedDifference{
      .name = std::string(metric.name),
      .unit = std::string(metric.unit),
      .pairs = static_cast<int>(differences.size()),
      .a = Mean(of_a),
      .b = Mean(of_b),
      .difference = MeanInterval(differences),
      .resolvable = (StudentsTQuantile(kUpper, freedom) + StudentsTQuantile(kPower, freedom)) * standard_error,
      .larger_is_better = metric.larger_is_better};
}

/// Only what has a margin is judged, and the pass rate.
void Judge(PairedDifference& difference, const std::vector<Margin>& margins) {
  const auto found = std::find_if(margins.begin(), margins.end(),
                                  [&](const Margin& margin) { return margin.name == difference.name; });
  if (found == margins.end() && difference.name != kPassRate) return;
  difference.margin = found == margins.end() ? 0.0 : found->margin;
  const double sign = difference.larger_is_better ? -1.0 : 1.0;
  const double least_worse = std::min(sign * difference.difference.low, sign * difference.difference.high);
  difference.is_worse = least_worse > 0.0 && sign * difference.difference.value > difference.margin;
}

void CheckMargins(const std::vector<Margin>& margins) {
  for (const Margin& margin : margins) {
    if (margin.name != kPassRate && FindMetric(margin.name) == nullptr) {
      throw InputError(fmt::format("--margin: no metric of the name {}", margin.name));
    }
  }
}

/// A gate that judged nothing must not pass.
void RefuseUnjudged(const Margin& margin, const Comparison& comparison) {
  const bool is_judged = std::any_of(comparison.differences.begin(), comparison.differences.end(),
                                     [&](const PairedDifference& each) { return each.name == margin.name; });
  if (!is_judged) throw InputError(fmt::format("--margin {}: fewer than two pairs of flights have it", margin.name));
}

}  // namespace

bool Comparison::is_worse() const {
  return std::any_of(differences.begin(), differences.end(), [](const PairedDifference& d) { return d.is_worse; });
}

StoredResults LoadResults(const std::string& source) {
  if (fs::is_directory(source)) {
    const SweepStore store(source, SweepStore::Access::kRead);
    return {source, store.terms().keys(), store.Results()};
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
  if (part.results.empty()) throw InputError(fmt::format("{}: has no flight of a variant {}", stored.source, variant));
  return part;
}

Comparison Compare(const StoredResults& a, const StoredResults& b, const std::vector<Margin>& margins) {
  CheckMargins(margins);
  Comparison comparison;
  const std::vector<Pair> pairs = PairsOf(a, b, comparison);
  if (pairs.empty()) {
    throw InputError(
        fmt::format("{} and {}: have no flight of the same seed, variant and parameters", a.source, b.source));
  }
  comparison.differences.push_back(PassRateDifference(pairs));
  for (const MetricInfo& metric : AllMetrics()) {
    if (const auto difference = MetricDifference(metric, pairs)) comparison.differences.push_back(*difference);
  }
  for (PairedDifference& difference : comparison.differences) Judge(difference, margins);
  for (const Margin& margin : margins) RefuseUnjudged(margin, comparison);
  return comparison;
}

}  // namespace touchdown::scenarios
