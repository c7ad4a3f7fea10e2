#include "scenarios/sweeper/plan/flight_row.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "scenarios/util/enum_names.h"

namespace touchdown::sweeper {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 2;

/// Throws Json::exception or std::invalid_argument if `json` is not a row.
FlightRow RowFrom(const Json& json) {
  if (json.at("schema").get<int>() != kSchema) throw std::invalid_argument("unknown schema");
  FlightRow row;
  VisitColumns(row, [&json]<typename T>(const char* name, T& value) {
    if constexpr (std::is_enum_v<T>) {
      const std::optional<T> named = util::EnumFromName<T>(json.at(name).template get<std::string>());
      if (!named) throw std::invalid_argument(name);
      value = *named;
    } else {
      json.at(name).get_to(value);
    }
  });
  for (const auto& [name, value] : json.at("metrics").items()) row.metrics[name] = value;
  return row;
}

}  // namespace

std::string RowJson(const FlightRow& row) {
  Json json{{"schema", kSchema}};
  VisitColumns(row, [&json]<typename T>(const char* name, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      json[name] = Name(value);
    } else {
      json[name] = value;
    }
  });
  json["metrics"] = Json::object();
  for (const auto& [name, value] : row.metrics) json["metrics"][name] = value;
  // The output of a process may not be UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<FlightRow> RowFromJson(const std::string& text) {
  try {
    return RowFrom(Json::parse(text));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace touchdown::sweeper
