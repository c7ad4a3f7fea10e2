#include "scenarios/report/flight_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "models/error.h"
#include "scenarios/report/flight_plots.h"
#include "scenarios/report/flight_series.h"
#include "scenarios/report/page_assets.h"
#include "scenarios/report/published.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/text.h"

namespace touchdown::report {
namespace {

using Json = nlohmann::ordered_json;
using kainjow::mustache::data;

constexpr char kNone[] = "–";

/// A parsed JSON file. Every member throws InputError, naming file and key, when the content is not as expected.
class JsonFile {
 public:
  JsonFile(const std::string& text, std::string name) : name_(std::move(name)) {
    try {
      json_ = Json::parse(text);
    } catch (const Json::parse_error& error) {
      const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
      throw InputError(fmt::format("{}:{}: invalid JSON", name_, 1 + std::count(text.begin(), end, '\n')));
    }
  }

  const Json& root() const { return json_; }

  std::string Text(const Json& object, const char* key) const {
    const Json& value = Member(object, key);
    if (!value.is_string()) throw InputError(fmt::format("{}: {}: must be a string", name_, key));
    return value.get<std::string>();
  }
  double Number(const Json& object, const char* key) const {
    const Json& value = Member(object, key);
    if (!value.is_number()) throw InputError(fmt::format("{}: {}: must be a number", name_, key));
    return value.get<double>();
  }
  const Json& Member(const Json& object, const char* key) const {
    if (!object.is_object() || !object.contains(key)) {
      throw InputError(fmt::format("{}: {}: missing key", name_, key));
    }
    return object.at(key);
  }
  /// The array or object at a key of the root. `type` is the required type.
  const Json& Members(const char* key, Json::value_t type) const {
    const Json& value = Member(json_, key);
    if (value.type() != type) {
      throw InputError(
          fmt::format("{}: {}: must be an {}", name_, key, type == Json::value_t::array ? "array" : "object"));
    }
    return value;
  }

 private:
  std::string name_;
  Json json_;
};

std::string FourDigits(double value) { return fmt::format("{:.4g}", value); }

std::string DescriptionOf(std::string_view metric) {
  const runner::MetricInfo* const info = runner::FindMetric(metric);
  return info == nullptr ? "" : std::string(info->doc);
}

void PutVerdict(const JsonFile& result, data& page) {
  const std::string verdict = result.Text(result.root(), "verdict");
  const bool passed = verdict == "pass", failed = verdict == "fail";
  page.set("verdict", passed ? "pass" : failed ? "fail" : "error");
  page.set("verdict_word", passed ? "Passed" : failed ? "Failed" : "Error");
  page.set("verdict_sign", passed ? "✓" : failed ? "✗" : "!");
  page.set("outcome", util::Words(result.Text(result.root(), "outcome")));
  for (const char* key : {"scenario", "estimator", "version", "log_sha256"})
    page.set(key, result.Text(result.root(), key));
  const Json& seed = result.Member(result.root(), "seed");
  page.set("seed", seed.dump());
}

void PutChecks(const JsonFile& result, data& page) {
  data rows{data::type::list};
  int met = 0, all = 0;
  for (const Json& check : result.Members("checks", Json::value_t::array)) {
    const Json& value = result.Member(check, "value");
    const Json& pass = result.Member(check, "pass");
    const bool is_met = pass.is_boolean() && pass.get<bool>();
    data row;
    row.set("name", result.Text(check, "name"));
    row.set("doc", DescriptionOf(result.Text(check, "name")));
    row.set("value", value.is_number() ? FourDigits(value) : value.is_string() ? util::Words(value) : kNone);
    row.set("unit", result.Text(check, "unit"));
    row.set("limit", util::WithSigns(util::Words(result.Text(check, "limit"))));
    row.set("met", is_met ? data::type::bool_true : data::type::bool_false);
    rows << row;
    met += is_met ? 1 : 0;
    ++all;
  }
  page.set("checks", rows);
  page.set("checks_met", fmt::format("{} of {}", met, all));
}

/// Value of a metric; nullopt when the flight does not have it.
std::optional<double> Find(const Json& metrics, std::string_view name) {
  const auto found = metrics.find(name);
  return found == metrics.end() || !found->is_number() ? std::nullopt : std::optional(found->get<double>());
}

/// Touchdown from the metrics; nullopt when the vehicle did not touch down.
std::optional<Touchdown> TouchdownOf(const Json& metrics) {
  const auto t_s = Find(metrics, "flight.touchdown_time_s");
  const auto x_m = Find(metrics, "flight.touchdown_x_m"), y_m = Find(metrics, "flight.touchdown_y_m");
  return t_s && x_m && y_m ? std::optional(Touchdown{*t_s, *x_m, *y_m}) : std::nullopt;
}

/// Key values of the flight. Omits metrics that the flight does not have.
void PutGlance(const Json& metrics, const JsonFile& timing, data& page) {
  struct Item {
    const char* label;
    const char* metric;
    double scale;
    const char* unit;
  };
  constexpr std::array<Item, 7> kItems = {{{"Touchdown distance from center", "flight.touchdown_xy_error_m", 1e3, "mm"},
                                           {"Touchdown speed", "flight.touchdown_speed_m_s", 1.0, "m/s"},
                                           {"Hover position error, RMS", "flight.hover_xyz_rmse_m", 1e3, "mm"},
                                           {"Vision horizontal RMSE", "estimate.xy_rmse_m", 1e3, "mm"},
                                           {"Vision vertical RMSE", "estimate.z_rmse_m", 1e3, "mm"},
                                           {"Pad detected when in view", "estimate.availability", 100.0, "%"},
                                           {"Flight duration", "flight.sim_time_s", 1.0, "s"}}};
  data items{data::type::list};
  const auto put = [&items](const char* label, double value, const char* unit) {
    data item;
    item.set("label", label);
    item.set("value", fmt::format("{:.3g}", value));
    item.set("unit", unit);
    items << item;
  };
  for (const Item& item : kItems) {
    if (const auto value = Find(metrics, item.metric)) put(item.label, *value * item.scale, item.unit);
  }
  put("Vision time per frame, mean", timing.Number(timing.root(), "vision_ms_mean"), "ms");
  page.set("glance", items);
}

/// RMSE of the flight with the values of Table I of the paper for hovering and for autonomous flight.
void PutTableOne(const Json& metrics, data& page) {
  data rows{data::type::list};
  for (const TableOneRow& row : kTableOne) {
    const auto value = Find(metrics, row.metric);
    const auto ratio = [&](double paper) { return value ? fmt::format("{:.2f}", *value * row.scale / paper) : kNone; };
    data cells;
    cells.set("label", std::string(row.label));
    cells.set("unit", std::string(row.unit));
    cells.set("value", value ? fmt::format("{:.3g}", *value * row.scale) : kNone);
    cells.set("hovering", fmt::format("{:.1f}", row.published[1]));
    cells.set("hovering_ratio", ratio(row.published[1]));
    cells.set("autonomous", fmt::format("{:.1f}", row.published[2]));
    cells.set("autonomous_ratio", ratio(row.published[2]));
    rows << cells;
  }
  page.set("table_one", rows);
}

void PutMetrics(const Json& metrics, data& page) {
  data rows{data::type::list};
  for (const runner::MetricInfo& info : runner::AllMetrics()) {
    const auto value = Find(metrics, info.name);
    data row;
    row.set("name", std::string(info.name));
    row.set("value", value ? FourDigits(*value) : kNone);
    row.set("unit", std::string(info.unit));
    row.set("doc", std::string(info.doc));
    rows << row;
  }
  page.set("metrics", rows);
}

void PutTiming(const JsonFile& timing, data& page) {
  for (const char* key : {"vision_ms_mean", "vision_ms_p99", "render_ms_mean", "realtime_factor"}) {
    page.set(key, fmt::format("{:.3g}", timing.Number(timing.root(), key)));
  }
}

void PutPlatform(const JsonFile& result, data& page) {
  data rows{data::type::list};
  for (const auto& [name, value] : result.Members("platform", Json::value_t::object).items()) {
    data row;
    row.set("name", util::Words(name));
    row.set("value", value.is_string() ? value.get<std::string>() : value.dump());
    rows << row;
  }
  page.set("platform", rows);
}

/// JSON text that is safe inside an HTML script element: escapes `<` and the line separators U+2028 and U+2029.
std::string Inlined(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string inlined;
  inlined.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = std::string_view(text).substr(i, 3);
    if (text[i] == '<') {
      inlined += "\\u003c";
    } else if (rest == "\u2028" || rest == "\u2029") {
      inlined += rest == "\u2028" ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      inlined += text[i];
    }
  }
  return inlined;
}

std::string Rendered(const data& page) {
  kainjow::mustache::mustache page_template{std::string(PageTemplate())};
  if (!page_template.is_valid()) throw std::logic_error("flight report template: " + page_template.error_message());
  return page_template.render(page);
}

}  // namespace

std::string FlightPage(const FlightFiles& files) {
  const JsonFile result(files.result_json, files.NameOf("result.json"));
  const JsonFile timing(files.timing_json, files.NameOf("timing.json"));
  const runner::Scenario scenario =
      runner::ParseScenario(files.scenario_yaml, files.NameOf("scenario.yaml"), files.folder);
  const Json& metrics = result.Members("metrics", Json::value_t::object);

  data page;
  page.set("signature", kFlightPageSignature);
  page.set("style", std::string(PageStyle()));
  page.set("script", std::string(PageScript()));
  PutVerdict(result, page);
  PutChecks(result, page);
  PutGlance(metrics, timing, page);
  PutTableOne(metrics, page);
  PutMetrics(metrics, page);
  PutTiming(timing, page);
  PutPlatform(result, page);
  page.set("description", scenario.description);
  page.set("scenario_yaml", files.scenario_yaml);
  page.set("has_video", files.has_video ? data::type::bool_true : data::type::bool_false);
  const FlightSeries series = ReadFlightSeries(files, 1.0 / scenario.camera.rate_hz);
  page.set("flight", Inlined(FlightPlots(series, TouchdownOf(metrics), scenario)));
  return Rendered(page);
}

}  // namespace touchdown::report
