#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace touchdown::util {

/// Result of parsing a token as a number.
template <typename T>
struct NumberToken {
  std::optional<T> value = {};   ///< nullopt if the whole token is not a number. "inf" and "nan" are numbers.
  bool is_out_of_range = false;  ///< The token is a number, but T cannot represent it: "1e999", "300" for a byte.
};

/// Reads a whole token as a decimal number of type T, in the format of std::from_chars: no blanks, no leading "+".
/// Subnormal numbers are read exactly.
template <typename T>
NumberToken<T> ReadNumber(std::string_view token) {
  T value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size()) return {};
  if (error == std::errc::result_out_of_range) return {.is_out_of_range = true};
  return error == std::errc() ? NumberToken<T>{.value = value} : NumberToken<T>{};
}

/// Parses a whole token as a finite number; nullopt for any other token.
template <typename T = double>
std::optional<T> FiniteNumber(std::string_view token) {
  const std::optional<T> value = ReadNumber<T>(token).value;
  if constexpr (std::is_floating_point_v<T>) {
    if (value && !std::isfinite(*value)) return std::nullopt;
  }
  return value;
}

}  // namespace touchdown::util
