#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// JSON of a parameter's value, with numbers as JSON numbers.
inline nlohmann::ordered_json ParameterJson(const std::string& yaml) {
  constexpr double kLargest = 1e15;
  const auto number = AsNumber(yaml);
  if (!number || fmt::format("{}", *number) != yaml) return yaml;
  const bool is_whole = *number == std::floor(*number) && std::abs(*number) < kLargest;
  return is_whole ? nlohmann::ordered_json(static_cast<std::int64_t>(*number)) : nlohmann::ordered_json(*number);
}

/// Inverse of ParameterJson.
inline std::string ParameterFrom(const nlohmann::ordered_json& json) {
  if (json.is_number()) return fmt::format("{}", json.get<double>());
  return json.get<std::string>();
}

}  // namespace touchdown::sweeper
