#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace touchdown::util {

/// Text of a number with `digits` digits after the decimal point; "-0.0" becomes "0.0".
inline std::string Fixed(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text[0] == '-' ? text.substr(1) : text;
}

/// Text of a number as in Fixed, or "none".
inline std::string FixedOrNone(const std::optional<double>& value, int digits) {
  return value ? Fixed(*value, digits) : "none";
}

/// Limit for display: "<= 0.06" becomes "≤ 0.06".
inline std::string WithSigns(std::string limit) {
  for (const auto& [ascii, sign] : {std::pair("<=", "≤"), std::pair(">=", "≥"), std::pair("..", "–")}) {
    if (const std::size_t at = limit.find(ascii); at != std::string::npos) limit.replace(at, 2, sign);
  }
  return limit;
}

/// Name for display: "gave_up" becomes "gave up".
inline std::string Words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace touchdown::util
