#include "scenarios/sweeper/plan/flight_row.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace touchdown::sweeper {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

std::optional<FlightRow> RowFrom(const Json& json) {
  const std::optional<RowEnd> end = RowEndFrom(json.at("end").get<std::string>());
  if (json.at("schema").get<int>() != kSchema || !end) return std::nullopt;
  FlightRow row;
  row.end = *end;
  row.id = json.at("id");
  row.program = json.at("program");
  row.version = json.at("version");
  row.host = json.at("host");
  row.verdict = json.at("verdict");
  row.outcome = json.at("outcome");
  row.reason = json.at("reason");
  row.failed_check = json.at("failed_check");
  row.failed_phase = json.at("failed_phase");
  for (const auto& [name, value] : json.at("metrics").items()) row.metrics[name] = value;
  row.log_sha256 = json.at("log_sha256");
  row.wall_s = json.at("wall_s");
  row.complaint = json.at("complaint");
  row.scenario_yaml = json.at("scenario");
  return row;
}

}  // namespace

std::optional<RowEnd> RowEndFrom(std::string_view name) {
  const auto found = std::find(kRowEndNames.begin(), kRowEndNames.end(), name);
  if (found == kRowEndNames.end()) return std::nullopt;
  return static_cast<RowEnd>(found - kRowEndNames.begin());
}

std::string RowJson(const FlightRow& row) {
  Json json{{"schema", kSchema},
            {"id", row.id},
            {"program", row.program},
            {"version", row.version},
            {"host", row.host},
            {"end", Name(row.end)},
            {"verdict", row.verdict},
            {"outcome", row.outcome},
            {"reason", row.reason},
            {"failed_check", row.failed_check},
            {"failed_phase", row.failed_phase},
            {"metrics", Json::object()},
            {"log_sha256", row.log_sha256},
            {"wall_s", row.wall_s},
            {"complaint", row.complaint},
            {"scenario", row.scenario_yaml}};
  for (const auto& [name, value] : row.metrics) json["metrics"][name] = value;
  // What a process says may be no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<FlightRow> RowFromJson(const std::string& text) {
  try {
    return RowFrom(Json::parse(text));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace touchdown::sweeper
