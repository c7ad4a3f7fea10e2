#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Converts a YAML parameter value to JSON: a number if that preserves its text, otherwise a string.
inline nlohmann::ordered_json ParameterJson(const std::string& yaml) {
  constexpr double kLargest = 1e15;
  const auto number = AsNumber(yaml);
  if (!number || fmt::format("{}", *number) != yaml) return yaml;
  const bool is_integer = *number == std::floor(*number) && std::abs(*number) < kLargest;
  return is_integer ? nlohmann::ordered_json(static_cast<std::int64_t>(*number)) : nlohmann::ordered_json(*number);
}

/// Inverse of ParameterJson.
inline std::string ParameterFrom(const nlohmann::ordered_json& json) {
  if (json.is_number()) return fmt::format("{}", json.get<double>());
  return json.get<std::string>();
}

}  // namespace touchdown::sweeper
