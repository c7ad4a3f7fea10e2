#include "scenarios/sweeper/plan/sweep_spec.h"

#include <nlohmann/json.hpp>

#include "models/error.h"

namespace touchdown::sweeper {
namespace {

using Json = nlohmann::ordered_json;

void PutIfSet(Json& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

std::optional<double> OptionalNumber(const Json& json, const char* key) {
  return json.contains(key) ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

SweepSpec SpecFrom(const Json& json) {
  SweepSpec spec{.name = json.at("name"), .description = json.at("description"), .variants = json.at("variants")};
  for (const Json& axis : json.at("parameters")) spec.axes.push_back({axis.at("key"), axis.at("listed")});
  for (const Json& criterion : json.at("criteria")) {
    spec.criteria.push_back({.metric = criterion.at("metric"),
                             .quantile = OptionalNumber(criterion, "quantile"),
                             .min = OptionalNumber(criterion, "min"),
                             .max = OptionalNumber(criterion, "max"),
                             .by = criterion.contains("by") ? JudgedBy::kInterval : JudgedBy::kValue});
  }
  if (json.contains("stop_when")) {
    const Json& stop = json.at("stop_when");
    spec.stop_when = {.good_pass_rate = stop.at("good_pass_rate"),
                      .bad_pass_rate = stop.at("bad_pass_rate"),
                      .good_refused = stop.at("good_refused"),
                      .bad_accepted = stop.at("bad_accepted")};
  }
  if (json.contains("search")) {
    const Json& search = json.at("search");
    spec.search = {
        .key = search.at("key"), .min = search.at("min"), .max = search.at("max"), .pass_rate = search.at("pass_rate")};
  }
  return spec;
}

}  // namespace

std::vector<std::string> SweepSpec::keys() const {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : axes) keys.push_back(axis.key);
  return keys;
}

std::vector<std::string> SweepSpec::flown_variants() const {
  return variants.empty() ? std::vector<std::string>{""} : variants;
}

SweepSpec SpecOf(const SweepFile& file) {
  SweepSpec spec{.name = file.name,
                 .description = file.description,
                 .criteria = file.criteria,
                 .stop_when = file.stop_when,
                 .search = file.search};
  for (const SweepParameter& parameter : file.parameters) {
    const auto* listed = std::get_if<ListedValues>(&parameter.values);
    spec.axes.push_back({parameter.key, listed == nullptr ? std::vector<std::string>() : listed->yaml});
  }
  for (const SweepVariant& variant : file.variants) {
    if (!variant.name.empty()) spec.variants.push_back(variant.name);
  }
  return spec;
}

std::string SpecJson(const SweepSpec& spec) {
  Json json{{"name", spec.name},
            {"description", spec.description},
            {"parameters", Json::array()},
            {"variants", spec.variants},
            {"criteria", Json::array()}};
  for (const SweepAxis& axis : spec.axes) json["parameters"].push_back({{"key", axis.key}, {"listed", axis.listed}});
  for (const SweepCriterion& criterion : spec.criteria) {
    Json each{{"metric", criterion.metric}};
    PutIfSet(each, "quantile", criterion.quantile);
    PutIfSet(each, "min", criterion.min);
    PutIfSet(each, "max", criterion.max);
    if (criterion.by == JudgedBy::kInterval) each["by"] = kJudgedByNames[1];
    json["criteria"].push_back(each);
  }
  if (spec.stop_when) {
    json["stop_when"] = {{"good_pass_rate", spec.stop_when->good_pass_rate},
                         {"bad_pass_rate", spec.stop_when->bad_pass_rate},
                         {"good_refused", spec.stop_when->good_refused},
                         {"bad_accepted", spec.stop_when->bad_accepted}};
  }
  if (spec.search) {
    json["search"] = {{"key", spec.search->key},
                      {"min", spec.search->min},
                      {"max", spec.search->max},
                      {"pass_rate", spec.search->pass_rate}};
  }
  return json.dump();
}

SweepSpec SpecFromJson(const std::string& text) {
  try {
    return SpecFrom(Json::parse(text));
  } catch (const Json::exception&) {
    throw InputError("invalid sweep specification");
  }
}

}  // namespace touchdown::sweeper
