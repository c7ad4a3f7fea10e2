#include "scenarios/sweep/sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "models/random_stream.h"
#include "scenarios/flight/expected_duration.h"
#include "scenarios/flight/sha256.h"

namespace touchdown::scenarios {
namespace {

/// Of `count` equal parts of the unit interval, the one that the seed of this place is in.
std::size_t PartOf(std::size_t place, std::size_t count, const std::string& key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  models::RandomStream random(count, "sweep.order." + key);
  for (std::size_t i = count - 1; i > 0; --i) {
    std::swap(order[i], order[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(i)))]);
  }
  return order[place];
}

/// The values of one parameter for one seed; a drawn one is a single.
std::vector<std::string> ValuesFor(const SweepParameter& parameter, std::uint64_t seed, std::size_t place,
                                   std::size_t count) {
  models::RandomStream random(seed, "sweep." + parameter.key);
  struct Draw {
    models::RandomStream& random;
    const std::string& key;
    std::size_t place, count;

    std::vector<std::string> operator()(const ListedValues& listed) const { return listed.yaml; }
    std::vector<std::string> operator()(const UniformValues& u) const { return {Text(random.Uniform(u.min, u.max))}; }
    std::vector<std::string> operator()(const NormalValues& n) const {
      return {Text(n.mean + n.sigma * random.Normal())};
    }
    std::vector<std::string> operator()(const LatinHypercubeValues& l) const {
      const double part =
          (static_cast<double>(PartOf(place, count, key)) + random.Uniform()) / static_cast<double>(count);
      return {Text(std::lerp(l.min, l.max, part))};
    }
    static std::string Text(double value) { return fmt::format("{}", value); }
  };
  return std::visit(Draw{random, parameter.key, place, count}, parameter.values);
}

/// Every combination of one value of each parameter, the last one's changing first.
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
  std::vector<Override> overrides = file.set;
  overrides.insert(overrides.end(), variant.set.begin(), variant.set.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SweepParameter& parameter = file.parameters[i];
    overrides.emplace_back(fmt::format("{}={}", parameter.key, values[i]), parameter.place);
  }
  overrides.emplace_back(fmt::format("seed={}", seed));
  const Scenario scenario = LoadScenario(file.base, overrides);
  PlannedFlight flight{.seed = seed, .variant = variant.name, .values = std::move(values)};
  flight.scenario_yaml = ScenarioYaml(scenario);
  flight.id = FlightId(flight.scenario_yaml, program_digest);
  flight.expected_s = ExpectedDuration_s(scenario);
  flight.limit_s = file.limits.wall_s.value_or(DefaultLimit_s(scenario));
  return flight;
}

}  // namespace

std::string FlightId(const std::string& scenario_yaml, const std::string& program_digest) {
  constexpr std::size_t kDigits = 16;
  return Sha256({&scenario_yaml, &program_digest}).substr(0, kDigits);
}

double DefaultLimit_s(const Scenario& scenario) {
  constexpr double kStart_s = 60.0, kSlowest = 30.0;
  return kStart_s + kSlowest * ExpectedDuration_s(scenario);
}

SweepPlan PlanSweep(const SweepFile& file, const std::string& program_digest) {
  SweepPlan plan;
  for (const SweepParameter& parameter : file.parameters) plan.keys.push_back(parameter.key);
  const auto count = static_cast<std::size_t>(file.seeds.count);
  for (std::size_t place = 0; place < count; ++place) {
    const std::uint64_t seed = static_cast<std::uint64_t>(file.seeds.from) + place;
    std::vector<std::vector<std::string>> values;
    for (const SweepParameter& parameter : file.parameters) values.push_back(ValuesFor(parameter, seed, place, count));
    for (const std::vector<std::string>& cell : Grid(values)) {
      for (const SweepVariant& variant : file.variants) {
        plan.flights.push_back(Planned(file, variant, seed, cell, program_digest));
        plan.flights.back().position = static_cast<std::int64_t>(plan.flights.size()) - 1;
      }
    }
  }
  return plan;
}

}  // namespace touchdown::scenarios
