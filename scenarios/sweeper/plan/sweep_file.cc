#include "scenarios/sweeper/plan/sweep_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "scenarios/config/config_reader.h"
#include "scenarios/config/config_writer.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/util/number.h"

namespace touchdown::sweeper {

void Describe(models::ConfigVisitor& v, SweepSeeds& seeds) {
  v.Integer({"from", "First seed."}, seeds.from, models::Between(0, 1e15));
  v.Integer({"count", "Number of seeds."}, seeds.count, models::Between(1, 1e6));
}

void Describe(models::ConfigVisitor& v, FlightLimits& limits) {
  v.OptionalNumber({"wall_s", "Limit of a flight's wall time. Default: a minute and 30 times the expected flight."},
                   limits.wall_s, models::kSecond, models::kPositive);
  v.Integer({"memory_mb", "Limit of a flight's address space."}, limits.memory_mb, models::Between(256, 1e6));
}

void Describe(models::ConfigVisitor& v, SweepCriterion& criterion) {
  v.Text({"metric", "Name of a flight's metric, or pass_rate.", true}, criterion.metric);
  v.OptionalNumber({"quantile", "Quantile of the metric over the flights that have it."}, criterion.quantile,
                   models::kNoUnit, models::kFraction);
  v.OptionalNumber({"min", "Smallest value that passes."}, criterion.min, models::kNoUnit, models::kAny);
  v.OptionalNumber({"max", "Largest value that passes."}, criterion.max, models::kNoUnit, models::kAny);
  v.Choice({"by", "What must lie within the limits: the measured value, or its whole 95 % interval."}, criterion.by,
           kJudgedByNames);
  v.Check("", [&criterion] {
    const bool is_rate = criterion.metric == kPassRate;
    if (!is_rate && runner::FindMetric(criterion.metric) == nullptr) {
      throw InputError(fmt::format("no metric of the name {}", criterion.metric));
    }
    if (is_rate == criterion.quantile.has_value()) {
      throw InputError(is_rate ? "pass_rate has no quantile" : "a flight's metric needs a quantile");
    }
    if (!criterion.min && !criterion.max) throw InputError("needs min or max");
    if (criterion.min && criterion.max && *criterion.min > *criterion.max) throw InputError("min is above max");
    for (const std::optional<double>& limit : {criterion.min, criterion.max}) {
      if (is_rate && limit && !models::kFraction.Contains(*limit))
        throw InputError("a pass rate's limits are from 0 to 1");
    }
  });
}

void Describe(models::ConfigVisitor& v, StopWhen& stop) {
  const models::Range within{.min = 0.0, .max = 1.0, .min_is_open = true};
  v.Number({"good_pass_rate", "A pass rate that is good enough.", true}, stop.good_pass_rate, models::kNoUnit, within);
  v.Number({"bad_pass_rate", "A pass rate that is too low; below good_pass_rate.", true}, stop.bad_pass_rate,
           models::kNoUnit, within);
  v.Number({"good_refused", "Probability of refusing a sweep with good_pass_rate. Lower needs more flights."},
           stop.good_refused, models::kNoUnit, {.min = 0.0, .max = 0.5, .min_is_open = true});
  v.Number({"bad_accepted", "Probability of accepting a sweep with bad_pass_rate. Lower needs more flights."},
           stop.bad_accepted, models::kNoUnit, {.min = 0.0, .max = 0.5, .min_is_open = true});
  v.Check("bad_pass_rate", [&stop] {
    if (stop.bad_pass_rate >= stop.good_pass_rate) throw InputError("must be below good_pass_rate");
  });
}

namespace {

template <typename Bounds>
void DescribeBounds(models::ConfigVisitor& v, Bounds& bounds) {
  v.Number({"min", "The smallest value.", true}, bounds.min, models::kNoUnit, models::kAny);
  v.Number({"max", "The largest value.", true}, bounds.max, models::kNoUnit, models::kAny);
  v.Check("max", [&bounds] {
    if (bounds.max <= bounds.min) throw InputError("must be above min");
  });
}

}  // namespace

void Describe(models::ConfigVisitor& v, UniformValues& values) { DescribeBounds(v, values); }
void Describe(models::ConfigVisitor& v, LatinHypercubeValues& values) { DescribeBounds(v, values); }

void Describe(models::ConfigVisitor& v, NormalValues& values) {
  v.Number({"mean", "Mean.", true}, values.mean, models::kNoUnit, models::kAny);
  v.Number({"sigma", "Standard deviation.", true}, values.sigma, models::kNoUnit, models::kNotNegative);
}

namespace {

/// Values of an evenly spaced parameter.
struct RangeOfValues {
  double from = 0.0;
  double to = 1.0;
  int count = 2;
};

void Describe(models::ConfigVisitor& v, RangeOfValues& range) {
  v.Number({"from", "The first value.", true}, range.from, models::kNoUnit, models::kAny);
  v.Number({"to", "The last value.", true}, range.to, models::kNoUnit, models::kAny);
  v.Integer({"count", "Number of values.", true}, range.count, models::Between(2, 1e5));
  v.Check("to", [&range] {
    if (range.to == range.from) throw InputError("must differ from from");
  });
}

/// The keys that hold keys of the scenario.
constexpr std::array<std::string_view, 3> kKeysOfScenario = {"parameters", "variants", "set"};

/// The other keys, which are read field by field.
struct PlainKeys {
  SweepFile file;
  std::string base;
};

void Describe(models::ConfigVisitor& v, PlainKeys& keys) {
  SweepFile& file = keys.file;
  v.Text({"name", "Name of the sweep. Default: the file's name."}, file.name);
  v.Text({"description", "Purpose of the sweep in words."}, file.description);
  v.Text({"base", "Scenario to fly: the name of a file, relative to this file's folder.", true}, keys.base);
  v.Keys({"seeds", "Seeds; every combination of values is flown with each."}, file.seeds);
  v.Keys({"limits", "Limits of a flight."}, file.limits);
  v.Items({"criteria", "Bounds on results that the sweep must keep to pass."}, file.criteria);
  v.OptionalKeys({"stop_when", "Ends the sweep as soon as its pass rate is decided."}, file.stop_when, StopWhen());
}

/// A piece of configuration as YAML in one line.
std::string FlowYaml(const config::ConfigNode& node) {
  std::vector<std::string> parts;
  switch (node.kind) {
    case config::ConfigNode::Kind::kNothing:
      return "~";
    case config::ConfigNode::Kind::kText:
      return node.quoted || node.text.find_first_of(",[]{}") != std::string::npos ? config::WriteText(node.text)
                                                                                  : node.text;
    case config::ConfigNode::Kind::kList:
      for (const config::ConfigNode& item : node.items) parts.push_back(FlowYaml(item));
      return fmt::format("[{}]", fmt::join(parts, ", "));
    case config::ConfigNode::Kind::kKeys:
      for (const config::ConfigEntry& entry : node.keys)
        parts.push_back(fmt::format("{}: {}", entry.key, FlowYaml(entry.node)));
      break;
  }
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

/// A number in its shortest form, so that 2 and 2.0 are the same value; anything else as it is.
std::string Canonical(const std::string& yaml) {
  constexpr double kLargest = 1e15;  // Beyond it a double does not hold every whole number.
  const auto number = AsNumber(yaml);
  return number && std::abs(*number) < kLargest ? fmt::format("{}", *number) : yaml;
}

ListedValues ListOf(const config::ConfigNode& list, const std::string& path) {
  if (list.items.empty()) throw config::ConfigError(list.origin, path, "needs at least one value");
  ListedValues values;
  for (const config::ConfigNode& item : list.items) {
    const std::string yaml = Canonical(FlowYaml(item));
    if (std::find(values.yaml.begin(), values.yaml.end(), yaml) != values.yaml.end()) {
      throw config::ConfigError(item.origin, path, fmt::format("{} is there twice", yaml));
    }
    values.yaml.push_back(yaml);
  }
  return values;
}

ListedValues Spaced(const RangeOfValues& range) {
  ListedValues values;
  for (int i = 0; i < range.count; ++i) {
    const double share = static_cast<double>(i) / (range.count - 1);
    // Twelve digits: 0.1 and not 0.1 plus what counting up in steps adds to it.
    const std::string rounded = fmt::format("{:.12g}", std::lerp(range.from, range.to, share));
    values.yaml.push_back(fmt::format("{}", util::FiniteNumber(rounded).value()));
  }
  return values;
}

SweepParameter ParameterOf(const config::ConfigEntry& entry) {
  const config::ConfigNode& node = entry.node;
  const std::string path = "parameters." + entry.key;
  SweepParameter parameter{.key = entry.key, .place = node.origin.place, .folder = node.origin.folder, .values = {}};
  if (node.kind == config::ConfigNode::Kind::kList) {
    parameter.values = ListOf(node, path);
    return parameter;
  }
  const std::string kind =
      node.kind == config::ConfigNode::Kind::kKeys && node.keys.size() == 1 ? node.keys[0].key : "";
  if (kind == "range") {
    parameter.values = Spaced(config::ReadAlone<RangeOfValues>(node.keys[0].node));
  } else if (kind == "uniform") {
    parameter.values = config::ReadAlone<UniformValues>(node.keys[0].node);
  } else if (kind == "normal") {
    parameter.values = config::ReadAlone<NormalValues>(node.keys[0].node);
  } else if (kind == "latin_hypercube") {
    parameter.values = config::ReadAlone<LatinHypercubeValues>(node.keys[0].node);
  } else {
    throw config::ConfigError(node.origin, path,
                              "must be a list of values, or one of range, uniform, normal, latin_hypercube");
  }
  return parameter;
}

std::vector<SweepParameter> ParametersOf(const config::ConfigNode& node) {
  if (node.kind != config::ConfigNode::Kind::kKeys)
    throw config::ConfigError(node.origin, "parameters", "must hold keys");
  std::vector<SweepParameter> parameters;
  for (const config::ConfigEntry& entry : node.keys) {
    if (entry.key == "seed") throw config::ConfigError(entry.node.origin, "parameters.seed", "is given by seeds");
    parameters.push_back(ParameterOf(entry));
  }
  return parameters;
}

std::vector<runner::Override> OverridesOf(const config::ConfigNode& node, const std::string& path) {
  if (node.kind != config::ConfigNode::Kind::kKeys)
    throw config::ConfigError(node.origin, path, "must hold keys of the scenario");
  std::vector<runner::Override> overrides;
  for (const config::ConfigEntry& change : node.keys) {
    const config::Origin& origin = change.node.origin;
    if (change.key == "seed") throw config::ConfigError(origin, path + ".seed", "is given by seeds");
    overrides.emplace_back(fmt::format("{}={}", change.key, FlowYaml(change.node)), origin.place, origin.folder);
  }
  return overrides;
}

SweepVariant VariantOf(const config::ConfigNode& node, const std::string& path) {
  if (node.kind != config::ConfigNode::Kind::kKeys) throw config::ConfigError(node.origin, path, "must hold keys");
  SweepVariant variant{.name = {}, .place = node.origin.place};
  for (const config::ConfigEntry& entry : node.keys) {
    if (entry.key == "name" && entry.node.kind == config::ConfigNode::Kind::kText) {
      variant.name = entry.node.text;
    } else if (entry.key == "set") {
      variant.set = OverridesOf(entry.node, path + ".set");
    } else {
      throw config::ConfigError(entry.node.origin, path + "." + entry.key,
                                "known here: name (text), set (keys of the scenario)");
    }
  }
  if (variant.name.empty()) throw config::ConfigError(node.origin, path + ".name", "must be given");
  return variant;
}

std::vector<SweepVariant> VariantsOf(const config::ConfigNode& node) {
  if (node.kind != config::ConfigNode::Kind::kList || node.items.size() < 2) {
    throw config::ConfigError(node.origin, "variants", "must be a list of two or more");
  }
  std::vector<SweepVariant> variants;
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    variants.push_back(VariantOf(node.items[i], fmt::format("variants.{}", i)));
    if (!names.insert(variants.back().name).second) {
      throw config::ConfigError(node.items[i].origin, fmt::format("variants.{}.name", i), "is there twice");
    }
  }
  return variants;
}

/// The keys that a piece of configuration sets, each as the path to a value.
void AddPaths(const config::ConfigNode& node, const std::string& path, std::vector<std::string>& paths) {
  if (node.kind != config::ConfigNode::Kind::kKeys) return paths.push_back(path);
  for (const config::ConfigEntry& entry : node.keys)
    AddPaths(entry.node, path.empty() ? entry.key : path + "." + entry.key, paths);
}

/// Whether two paths are the same, or one is within the other.
bool Overlap(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  return longer.starts_with(shorter) && (longer.size() == shorter.size() || longer[shorter.size()] == '.');
}

/// A parameter gives its key to every flight: nothing else may.
void RefuseGivenTwice(const SweepFile& file, const config::ConfigNode* set, const config::ConfigNode* variants) {
  std::vector<std::string> elsewhere;
  if (set != nullptr) AddPaths(*set, "", elsewhere);
  if (variants != nullptr) {
    for (const config::ConfigNode& variant : variants->items) {
      if (const config::ConfigNode* const its_set = variant.Find("set")) AddPaths(*its_set, "", elsewhere);
    }
  }
  for (const SweepParameter& parameter : file.parameters) {
    for (const std::string& other : elsewhere) {
      if (!Overlap(parameter.key, other)) continue;
      throw InputError(fmt::format("{}: parameters.{}: {} is set as well", parameter.place, parameter.key, other));
    }
    elsewhere.push_back(parameter.key);
  }
}

/// The sequential test is of one pass rate.
void CheckStopWhen(const SweepFile& file, const config::Origin& origin) {
  const auto lists_several = [](const SweepParameter& parameter) {
    const auto* const listed = std::get_if<ListedValues>(&parameter.values);
    return listed != nullptr && listed->yaml.size() > 1;
  };
  if (file.variants.size() > 1 || std::any_of(file.parameters.begin(), file.parameters.end(), lists_several)) {
    throw config::ConfigError(origin, "stop_when",
                              "is of one pass rate: no variants and no grid, drawn parameters alone");
  }
  const auto by_interval = [](const SweepCriterion& criterion) {
    return criterion.metric == kPassRate && criterion.by == JudgedBy::kInterval;
  };
  if (std::any_of(file.criteria.begin(), file.criteria.end(), by_interval)) {
    throw config::ConfigError(origin, "stop_when", "decides on the pass rate; an interval of it does not hold then");
  }
}

}  // namespace

std::optional<double> AsNumber(const std::string& yaml) { return util::FiniteNumber(yaml); }

SweepFile LoadSweepFile(const std::filesystem::path& file) {
  const config::ConfigNode root = config::ReadConfigFile(file);
  const config::ConfigNode* base = root.Find("base");
  const config::Origin base_origin = base != nullptr ? base->origin : root.origin;
  PlainKeys keys = config::ReadAlone<PlainKeys>(root, kKeysOfScenario);
  SweepFile sweep = std::move(keys.file);
  sweep.place = file.string();
  if (sweep.name.empty()) sweep.name = file.stem().string();
  sweep.base = base_origin.folder / keys.base;
  std::error_code error;
  if (!std::filesystem::is_regular_file(sweep.base, error)) {
    throw config::ConfigError(base_origin, "base", fmt::format("no file {}", sweep.base.string()));
  }
  const config::ConfigNode *const set = root.Find("set"), *const parameters = root.Find("parameters"),
                                  *const variants = root.Find("variants");
  if (set != nullptr) sweep.set = OverridesOf(*set, "set");
  if (parameters != nullptr) sweep.parameters = ParametersOf(*parameters);
  sweep.variants = variants != nullptr ? VariantsOf(*variants) : std::vector<SweepVariant>(1);
  RefuseGivenTwice(sweep, set, variants);
  if (const config::ConfigNode* const stop = root.Find("stop_when")) CheckStopWhen(sweep, stop->origin);
  return sweep;
}

}  // namespace touchdown::sweeper
