#include "scenarios/sweeper/plan/sweep_spec.h"

#include <nlohmann/json.hpp>

#include "models/error.h"

namespace touchdown::sweeper {
namespace {

using Json = nlohmann::ordered_json;

void PutIfThere(Json& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

std::optional<double> NumberIfThere(const Json& json, const char* key) {
  return json.contains(key) ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

SweepSpec TermsFrom(const Json& json) {
  SweepSpec terms{.name = json.at("name"), .description = json.at("description"), .variants = json.at("variants")};
  for (const Json& axis : json.at("parameters")) terms.axes.push_back({axis.at("key"), axis.at("listed")});
  for (const Json& criterion : json.at("criteria")) {
    terms.criteria.push_back({.metric = criterion.at("metric"),
                              .quantile = NumberIfThere(criterion, "quantile"),
                              .min = NumberIfThere(criterion, "min"),
                              .max = NumberIfThere(criterion, "max"),
                              .by = criterion.contains("by") ? JudgedBy::kInterval : JudgedBy::kValue});
  }
  if (json.contains("stop_when")) {
    const Json& stop = json.at("stop_when");
    terms.stop_when = {.good_pass_rate = stop.at("good_pass_rate"),
                       .bad_pass_rate = stop.at("bad_pass_rate"),
                       .good_refused = stop.at("good_refused"),
                       .bad_accepted = stop.at("bad_accepted")};
  }
  if (json.contains("sought")) {
    const Json& search = json.at("sought");
    terms.search = {
        .key = search.at("key"), .min = search.at("min"), .max = search.at("max"), .pass_rate = search.at("pass_rate")};
  }
  return terms;
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

SweepSpec TermsOf(const SweepFile& file) {
  SweepSpec terms{.name = file.name,
                  .description = file.description,
                  .criteria = file.criteria,
                  .stop_when = file.stop_when,
                  .search = file.search};
  for (const SweepParameter& parameter : file.parameters) {
    const auto* listed = std::get_if<ListedValues>(&parameter.values);
    terms.axes.push_back({parameter.key, listed == nullptr ? std::vector<std::string>() : listed->yaml});
  }
  for (const SweepVariant& variant : file.variants) {
    if (!variant.name.empty()) terms.variants.push_back(variant.name);
  }
  return terms;
}

std::string TermsJson(const SweepSpec& terms) {
  Json json{{"name", terms.name},
            {"description", terms.description},
            {"parameters", Json::array()},
            {"variants", terms.variants},
            {"criteria", Json::array()}};
  for (const SweepAxis& axis : terms.axes) json["parameters"].push_back({{"key", axis.key}, {"listed", axis.listed}});
  for (const SweepCriterion& criterion : terms.criteria) {
    Json each{{"metric", criterion.metric}};
    PutIfThere(each, "quantile", criterion.quantile);
    PutIfThere(each, "min", criterion.min);
    PutIfThere(each, "max", criterion.max);
    if (criterion.by == JudgedBy::kInterval) each["by"] = kJudgedByNames[1];
    json["criteria"].push_back(each);
  }
  if (terms.stop_when) {
    json["stop_when"] = {{"good_pass_rate", terms.stop_when->good_pass_rate},
                         {"bad_pass_rate", terms.stop_when->bad_pass_rate},
                         {"good_refused", terms.stop_when->good_refused},
                         {"bad_accepted", terms.stop_when->bad_accepted}};
  }
  if (terms.search) {
    json["sought"] = {{"key", terms.search->key},
                      {"min", terms.search->min},
                      {"max", terms.search->max},
                      {"pass_rate", terms.search->pass_rate}};
  }
  return json.dump();
}

SweepSpec TermsFromJson(const std::string& text) {
  try {
    return TermsFrom(Json::parse(text));
  } catch (const Json::exception&) {
    throw InputError("does not hold the specification of a sweep");
  }
}

}  // namespace touchdown::sweeper
