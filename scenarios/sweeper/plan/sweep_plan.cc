#include "scenarios/sweeper/plan/sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "models/error.h"
#include "models/random_stream.h"
#include "scenarios/runner/expected_duration.h"
#include "scenarios/util/sha256.h"

namespace touchdown::sweeper {
namespace {

/// Random permutation for Latin hypercube sampling: for each seed, the index of its interval.
std::vector<std::size_t> IntervalOrder(std::size_t seeds, const std::string& key) {
  std::vector<std::size_t> parts(seeds);
  std::iota(parts.begin(), parts.end(), 0);
  models::RandomStream random(seeds, "sweep.order." + key);
  for (std::size_t i = seeds - 1; i > 0; --i) {
    std::swap(parts[i], parts[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(i)))]);
  }
  return parts;
}

/// Values of a parameter for a seed: all listed values, or a single drawn one.
std::vector<std::string> ValuesFor(const SweepParameter& parameter, std::uint64_t seed, std::size_t seed_index,
                                   const std::vector<std::size_t>& parts) {
  models::RandomStream random(seed, "sweep." + parameter.key);
  struct Draw {
    models::RandomStream& random;
    std::size_t seed_index;
    const std::vector<std::size_t>& parts;

    std::vector<std::string> operator()(const ListedValues& listed) const { return listed.yaml; }
    std::vector<std::string> operator()(const UniformValues& u) const { return {Text(random.Uniform(u.min, u.max))}; }
    std::vector<std::string> operator()(const NormalValues& n) const {
      return {Text(n.mean + n.sigma * random.Normal())};
    }
    std::vector<std::string> operator()(const LatinHypercubeValues& l) const {
      const double part =
          (static_cast<double>(parts[seed_index]) + random.Uniform()) / static_cast<double>(parts.size());
      return {Text(std::lerp(l.min, l.max, part))};
    }
    static std::string Text(double value) { return fmt::format("{}", value); }
  };
  return std::visit(Draw{random, seed_index, parts}, parameter.values);
}

/// All combinations of one value of each parameter. The value of the last parameter changes first.
std::vector<std::vector<std::string>> Grid(const std::vector<std::vector<std::string>>& values) {
  std::vector<std::vector<std::string>> grid{{}};
  for (const auto& choices : values) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& cell : grid) {
      for (const std::string& choice : choices) {
        longer.push_back(cell);
        longer.back().push_back(choice);
      }
    }
    grid = std::move(longer);
  }
  return grid;
}

PlannedFlight Planned(const SweepFile& file, const SweepVariant& variant, std::uint64_t seed,
                      std::vector<std::string> values, const std::string& program_digest) {
  std::vector<runner::Override> overrides = file.set;
  overrides.insert(overrides.end(), variant.set.begin(), variant.set.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepParameter& parameter = file.parameters[i];
    const bool is_drawn = !std::holds_alternative<ListedValues>(parameter.values);
    const std::string location =
        is_drawn ? fmt::format("{} (drawn for seed {})", parameter.location, seed) : parameter.location;
    overrides.emplace_back(fmt::format("{}={}", parameter.key, values[i]), location, parameter.folder);
  }
  overrides.emplace_back(fmt::format("seed={}", seed));
  const runner::Scenario scenario = runner::LoadScenario(file.base, overrides);
  PlannedFlight flight{.seed = seed, .variant = variant.name, .values = std::move(values)};
  flight.scenario_yaml = runner::ScenarioYaml(scenario);
  flight.id = FlightId(flight.scenario_yaml, program_digest);
  flight.expected_s = runner::ExpectedDuration_s(scenario);
  flight.limit_s = file.limits.wall_s.value_or(DefaultLimit_s(scenario));
  return flight;
}

void RejectTooManyFlights(const SweepFile& file) {
  constexpr double kMaxFlights = 100000.0;
  double flights = static_cast<double>(file.seeds.count) * static_cast<double>(file.variants.size());
  for (const SweepParameter& parameter : file.parameters) {
    if (const auto* listed = std::get_if<ListedValues>(&parameter.values)) {
      flights *= static_cast<double>(listed->yaml.size());
    }
  }
  if (flights > kMaxFlights)
    throw InputError(
        fmt::format("{}: the sweep has {:.6g} flights; allowed: at most {:.0f}", file.location, flights, kMaxFlights));
}

/// Variant and parameters of a flight as text, such as "variant a, camera.noise_sigma=4".
std::string FlightText(const SweepPlan& plan, const PlannedFlight& flight) {
  std::vector<std::string> words;
  if (!flight.variant.empty()) words.push_back("variant " + flight.variant);
  for (std::size_t i = 0; i < plan.keys.size(); ++i) words.push_back(plan.keys[i] + "=" + flight.values[i]);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Location and key of the first difference between two flights of a seed.
std::string LocationOfDifference(const SweepFile& file, const PlannedFlight& a, const PlannedFlight& b) {
  for (std::size_t i = 0; i < file.parameters.size(); ++i) {
    if (a.values[i] != b.values[i]) {
      return fmt::format("{}: parameters.{}", file.parameters[i].location, file.parameters[i].key);
    }
  }
  const auto variant = std::find_if(file.variants.begin(), file.variants.end(),
                                    [&](const SweepVariant& each) { return each.name == b.variant; });
  return variant->location + ": variants";
}

/// Throws InputError if two flights are the same: values with the same meaning, or variants that do not differ.
void RejectDuplicateFlights(const SweepFile& file, const SweepPlan& plan) {
  std::map<std::string, const PlannedFlight*> by_id;
  for (const PlannedFlight& flight : plan.flights) {
    const auto [at, is_new] = by_id.emplace(flight.id, &flight);
    if (is_new) continue;
    throw InputError(fmt::format("{}: ({}) and ({}) are the same flight",
                                 LocationOfDifference(file, *at->second, flight), FlightText(plan, *at->second),
                                 FlightText(plan, flight)));
  }
}

}  // namespace

std::string FlightId(const std::string& scenario_yaml, const std::string& program_digest) {
  constexpr std::size_t kDigits = 16;
  return util::Sha256(scenario_yaml + program_digest).substr(0, kDigits);
}

double DefaultLimit_s(const runner::Scenario& scenario) {
  constexpr double kStart_s = 60.0, kSlowest = 30.0;
  return kStart_s + kSlowest * runner::ExpectedDuration_s(scenario);
}

SweepPlan PlanSweep(const SweepFile& file, const std::string& program_digest) {
  RejectTooManyFlights(file);
  const auto seeds = static_cast<std::size_t>(file.seeds.count);
  SweepPlan plan;
  std::vector<std::vector<std::size_t>> parts;
  for (const SweepParameter& parameter : file.parameters) {
    plan.keys.push_back(parameter.key);
    parts.push_back(IntervalOrder(seeds, parameter.key));
  }
  for (std::size_t seed_index = 0; seed_index < seeds; ++seed_index) {
    const std::uint64_t seed = static_cast<std::uint64_t>(file.seeds.from) + seed_index;
    std::vector<std::vector<std::string>> values;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      values.push_back(ValuesFor(file.parameters[i], seed, seed_index, parts[i]));
    }
    for (const std::vector<std::string>& cell : Grid(values)) {
      for (const SweepVariant& variant : file.variants) {
        plan.flights.push_back(Planned(file, variant, seed, cell, program_digest));
        plan.flights.back().position = static_cast<std::int64_t>(plan.flights.size()) - 1;
      }
    }
    if (seed_index == 0) RejectDuplicateFlights(file, plan);  // The other seeds have the same combinations.
  }
  plan.total = plan.flights.size();
  return plan;
}

}  // namespace touchdown::sweeper
