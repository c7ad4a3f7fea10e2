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
  v.Integer({"from", "The seeds are counted up from this number."}, seeds.from, models::Between(0, 1e15));
  v.Integer({"count", "Number of seeds. More seeds narrow the confidence intervals and take longer."}, seeds.count,
            models::Between(1, 1e6));
}

void Describe(models::ConfigVisitor& v, FlightLimits& limits) {
  v.OptionalNumber(
      {"wall_s",
       "Elapsed time after which a flight is ended and reported as hung. Default: a minute plus 30 times the "
       "expected flight time."},
      limits.wall_s, models::kSecond, models::kPositive);
  v.Integer(
      {"memory_mb", "Address space of a flight; a flight that needs more is ended and reported as out of memory."},
      limits.memory_mb, models::Between(256, 1e6));
}

void Describe(models::ConfigVisitor& v, SweepCriterion& criterion) {
  v.Text({"metric", "The criterion is on this metric of flights, or on pass_rate.", true}, criterion.metric);
  v.OptionalNumber({"quantile", "The criterion is on this quantile of the metric, over the flights that have it."},
                   criterion.quantile, models::kNoUnit, models::kFraction);
  v.OptionalNumber({"min", "Values below this do not meet the criterion."}, criterion.min, models::kNoUnit,
                   models::kAny);
  v.OptionalNumber({"max", "Values above this do not meet the criterion."}, criterion.max, models::kNoUnit,
                   models::kAny);
  v.Choice({"by", "Selects what must be within the limits: the measured value, or its whole 95 % interval."},
           criterion.by, kJudgedByNames);
  v.Check("", [&criterion] {
    const bool is_rate = criterion.metric == kPassRate;
    if (!is_rate && runner::FindMetric(criterion.metric) == nullptr) {
      throw InputError(fmt::format("unknown metric {}", criterion.metric));
    }
    if (is_rate == criterion.quantile.has_value()) {
      throw InputError(is_rate ? "quantile is not allowed for pass_rate"
                               : "quantile must be given for a metric of flights");
    }
    if (!criterion.min && !criterion.max) throw InputError("min or max must be given");
    if (criterion.min && criterion.max && *criterion.min > *criterion.max)
      throw InputError("min must not be above max");
    for (const std::optional<double>& limit : {criterion.min, criterion.max}) {
      if (is_rate && limit && !models::kFraction.Contains(*limit))
        throw InputError("limits of pass_rate must be from 0 to 1");
    }
  });
}

void Describe(models::ConfigVisitor& v, StopWhen& stop) {
  const models::Range rate_range{.min = 0.0, .max = 1.0, .min_is_open = true};
  v.Number({"good_pass_rate", "A sweep with this pass rate is good.", true}, stop.good_pass_rate, models::kNoUnit,
           rate_range);
  v.Number(
      {"bad_pass_rate",
       "A sweep with this pass rate is bad. It must be below good_pass_rate. The test needs more flights if the two "
       "rates are close to each other.",
       true},
      stop.bad_pass_rate, models::kNoUnit, rate_range);
  v.Number(
      {"good_refused",
       "Approximate largest probability of the decision \"bad\" at good_pass_rate. A lower one needs more flights."},
      stop.good_refused, models::kNoUnit, {.min = 0.0, .max = 0.5, .min_is_open = true});
  v.Number(
      {"bad_accepted",
       "Approximate largest probability of the decision \"good\" at bad_pass_rate. A lower one needs more flights."},
      stop.bad_accepted, models::kNoUnit, {.min = 0.0, .max = 0.5, .min_is_open = true});
  v.Check("bad_pass_rate", [&stop] {
    if (stop.bad_pass_rate >= stop.good_pass_rate) throw InputError("must be below good_pass_rate");
  });
}

namespace {

template <typename Bounds>
void DescribeBounds(models::ConfigVisitor& v, Bounds& bounds) {
  v.Number({"min", "Drawn values are at least this.", true}, bounds.min, models::kNoUnit, models::kAny);
  v.Number({"max", "Drawn values are below this.", true}, bounds.max, models::kNoUnit, models::kAny);
  v.Check("max", [&bounds] {
    if (bounds.max <= bounds.min) throw InputError("must be above min");
  });
}

}  // namespace

void Describe(models::ConfigVisitor& v, UniformValues& values) { DescribeBounds(v, values); }
void Describe(models::ConfigVisitor& v, LatinHypercubeValues& values) { DescribeBounds(v, values); }

void Describe(models::ConfigVisitor& v, NormalValues& values) {
  v.Number({"mean", "The values are drawn from a normal distribution with this mean.", true}, values.mean,
           models::kNoUnit, models::kAny);
  v.Number({"sigma", "The values are drawn from a normal distribution with this standard deviation.", true},
           values.sigma, models::kNoUnit, models::kNotNegative);
}

namespace {

/// Values of an evenly spaced parameter.
struct RangeOfValues {
  double from = 0.0;
  double to = 1.0;
  int count = 2;
};

void Describe(models::ConfigVisitor& v, RangeOfValues& range) {
  v.Number({"from", "The first value of the range.", true}, range.from, models::kNoUnit, models::kAny);
  v.Number({"to", "The last value of the range.", true}, range.to, models::kNoUnit, models::kAny);
  v.Integer({"count", "Number of evenly spaced values, including the first and the last one.", true}, range.count,
            models::Between(2, 1e5));
  v.Check("to", [&range] {
    if (range.to == range.from) throw InputError("must differ from `from`");
  });
}

/// Keys of a sweep file whose children are scenario keys.
constexpr std::array<std::string_view, 3> kKeysOfScenario = {"parameters", "variants", "set"};

/// The other keys, which a ConfigVisitor reads.
struct PlainKeys {
  SweepFile file;
  std::string base;
};

void Describe(models::ConfigVisitor& v, PlainKeys& keys) {
  SweepFile& file = keys.file;
  v.Text({"name", "Name of the sweep. Default: the name of the file."}, file.name);
  v.Text({"description", "Purpose of the sweep in words, which the report shows."}, file.description);
  v.Text({"base", "Scenario to fly. It is the name of a file, relative to the folder of the sweep file.", true},
         keys.base);
  v.Keys({"seeds", "Every combination of values is flown with each of these seeds."}, file.seeds);
  v.Keys({"limits", "A flight that exceeds these limits is ended."}, file.limits);
  v.Items({"criteria", "The sweep passes if it meets all these criteria."}, file.criteria);
  v.OptionalKeys({"stop_when", "Ends the sweep when a sequential test has decided between two pass rates."},
                 file.stop_when, StopWhen());
}

/// Writes a configuration node as YAML in one line.
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

/// Writes a number in its shortest form, so that 2 and 2.0 are the same value; other text is unchanged.
std::string Canonical(const std::string& yaml) {
  constexpr double kLargest = 1e15;  // A double represents all integers below this.
  const auto number = AsNumber(yaml);
  return number && std::abs(*number) < kLargest ? fmt::format("{}", *number) : yaml;
}

ListedValues ListOf(const config::ConfigNode& list, const std::string& path) {
  if (list.items.empty()) throw config::ConfigError(list.origin, path, "must have at least one value");
  ListedValues values;
  for (const config::ConfigNode& item : list.items) {
    const std::string yaml = Canonical(FlowYaml(item));
    if (std::find(values.yaml.begin(), values.yaml.end(), yaml) != values.yaml.end()) {
      throw config::ConfigError(item.origin, path, fmt::format("{} is listed twice", yaml));
    }
    values.yaml.push_back(yaml);
  }
  return values;
}

ListedValues EvenlySpaced(const RangeOfValues& range) {
  ListedValues values;
  for (int i = 0; i < range.count; ++i) {
    const double fraction = static_cast<double>(i) / (range.count - 1);
    // Twelve digits remove rounding errors, so that for example 0.3 is not 0.30000000000000004.
    const std::string rounded = fmt::format("{:.12g}", std::lerp(range.from, range.to, fraction));
    values.yaml.push_back(fmt::format("{}", util::FiniteNumber(rounded).value()));
  }
  return values;
}

SweepParameter ParameterOf(const config::ConfigEntry& entry) {
  const config::ConfigNode& node = entry.node;
  const std::string path = "parameters." + entry.key;
  SweepParameter parameter{.key = entry.key, .location = node.origin.place, .folder = node.origin.folder, .values = {}};
  if (node.kind == config::ConfigNode::Kind::kList) {
    parameter.values = ListOf(node, path);
    return parameter;
  }
  const std::string kind =
      node.kind == config::ConfigNode::Kind::kKeys && node.keys.size() == 1 ? node.keys[0].key : "";
  if (kind == "range") {
    parameter.values = EvenlySpaced(config::ReadAlone<RangeOfValues>(node.keys[0].node));
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
    throw config::ConfigError(node.origin, "parameters", "must have keys");
  std::vector<SweepParameter> parameters;
  for (const config::ConfigEntry& entry : node.keys) {
    if (entry.key == "seed")
      throw config::ConfigError(entry.node.origin, "parameters.seed", "is not allowed; use the key seeds");
    parameters.push_back(ParameterOf(entry));
  }
  return parameters;
}

std::vector<runner::Override> OverridesOf(const config::ConfigNode& node, const std::string& path) {
  if (node.kind != config::ConfigNode::Kind::kKeys)
    throw config::ConfigError(node.origin, path, "must have scenario keys");
  std::vector<runner::Override> overrides;
  for (const config::ConfigEntry& change : node.keys) {
    const config::Origin& origin = change.node.origin;
    if (change.key == "seed") throw config::ConfigError(origin, path + ".seed", "is not allowed; use the key seeds");
    overrides.emplace_back(fmt::format("{}={}", change.key, FlowYaml(change.node)), origin.place, origin.folder);
  }
  return overrides;
}

SweepVariant VariantOf(const config::ConfigNode& node, const std::string& path) {
  if (node.kind != config::ConfigNode::Kind::kKeys) throw config::ConfigError(node.origin, path, "must have keys");
  SweepVariant variant{.name = {}, .location = node.origin.place};
  for (const config::ConfigEntry& entry : node.keys) {
    if (entry.key == "name" && entry.node.kind == config::ConfigNode::Kind::kText) {
      variant.name = entry.node.text;
    } else if (entry.key == "set") {
      variant.set = OverridesOf(entry.node, path + ".set");
    } else {
      throw config::ConfigError(entry.node.origin, path + "." + entry.key,
                                "is not allowed; allowed: name (text), set (scenario keys)");
    }
  }
  if (variant.name.empty()) throw config::ConfigError(node.origin, path + ".name", "must be given");
  return variant;
}

std::vector<SweepVariant> VariantsOf(const config::ConfigNode& node) {
  if (node.kind != config::ConfigNode::Kind::kList || node.items.size() < 2) {
    throw config::ConfigError(node.origin, "variants", "must be a list of at least two variants");
  }
  std::vector<SweepVariant> variants;
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    variants.push_back(VariantOf(node.items[i], fmt::format("variants.{}", i)));
    if (!names.insert(variants.back().name).second) {
      throw config::ConfigError(node.items[i].origin, fmt::format("variants.{}.name", i), "is listed twice");
    }
  }
  return variants;
}

/// Adds the paths of all values in a configuration node.
void AddPaths(const config::ConfigNode& node, const std::string& path, std::vector<std::string>& paths) {
  if (node.kind != config::ConfigNode::Kind::kKeys) return paths.push_back(path);
  for (const config::ConfigEntry& entry : node.keys)
    AddPaths(entry.node, path.empty() ? entry.key : path + "." + entry.key, paths);
}

/// Whether two paths are equal, or one contains the other.
bool Overlap(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  return longer.starts_with(shorter) && (longer.size() == shorter.size() || longer[shorter.size()] == '.');
}

/// Throws InputError if the key of a parameter is also set elsewhere in the file.
void RejectKeysSetTwice(const SweepFile& file, const config::ConfigNode* set, const config::ConfigNode* variants) {
  std::vector<std::string> elsewhere;
  if (set != nullptr) AddPaths(*set, "", elsewhere);
  if (variants != nullptr) {
    for (const config::ConfigNode& variant : variants->items) {
      if (const config::ConfigNode* const variant_set = variant.Find("set")) AddPaths(*variant_set, "", elsewhere);
    }
  }
  for (const SweepParameter& parameter : file.parameters) {
    for (const std::string& other : elsewhere) {
      if (!Overlap(parameter.key, other)) continue;
      throw InputError(fmt::format("{}: parameters.{}: {} is already set elsewhere in the file", parameter.location,
                                   parameter.key, other));
    }
    elsewhere.push_back(parameter.key);
  }
}

/// Throws ConfigError unless the sweep has a single pass rate, as the sequential test requires.
void CheckStopWhen(const SweepFile& file, const config::Origin& origin) {
  const auto lists_several = [](const SweepParameter& parameter) {
    const auto* const listed = std::get_if<ListedValues>(&parameter.values);
    return listed != nullptr && listed->yaml.size() > 1;
  };
  if (file.variants.size() > 1 || std::any_of(file.parameters.begin(), file.parameters.end(), lists_several)) {
    throw config::ConfigError(
        origin, "stop_when",
        "requires a single pass rate: variants and parameters with several listed values are not allowed");
  }
  const auto by_interval = [](const SweepCriterion& criterion) {
    return criterion.metric == kPassRate && criterion.by == JudgedBy::kInterval;
  };
  if (std::any_of(file.criteria.begin(), file.criteria.end(), by_interval)) {
    throw config::ConfigError(
        origin, "stop_when",
        "is not allowed with a criterion on the interval of pass_rate, which is invalid after an early stop");
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
  sweep.location = file.string();
  if (sweep.name.empty()) sweep.name = file.stem().string();
  sweep.base = base_origin.folder / keys.base;
  std::error_code error;
  if (!std::filesystem::is_regular_file(sweep.base, error)) {
    throw config::ConfigError(base_origin, "base", fmt::format("no such file: {}", sweep.base.string()));
  }
  const config::ConfigNode *const set = root.Find("set"), *const parameters = root.Find("parameters"),
                                  *const variants = root.Find("variants");
  if (set != nullptr) sweep.set = OverridesOf(*set, "set");
  if (parameters != nullptr) sweep.parameters = ParametersOf(*parameters);
  sweep.variants = variants != nullptr ? VariantsOf(*variants) : std::vector<SweepVariant>(1);
  RejectKeysSetTwice(sweep, set, variants);
  if (const config::ConfigNode* const stop = root.Find("stop_when")) CheckStopWhen(sweep, stop->origin);
  return sweep;
}

}  // namespace touchdown::sweeper
