#pragma once

// Text helpers for the figures of a sweep.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace touchdown::sweeper {

inline constexpr double kPercent = 100.0;
inline constexpr double kMillimeters = 1000.0;

// Passed and failed flights differ in color and in shape, so that either alone distinguishes them.
inline constexpr const char* kPassedPoints = "points pt 7 ps 0.5 lc rgb ESTIMATE";
inline constexpr const char* kFailedPoints = "points pt 2 ps 0.8 lw 1.8 lc rgb SET_POINT";

inline std::string Number(double value) { return fmt::format("{:.10g}", value); }

/// Quotes a text for gnuplot.
inline std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

/// Name of a figure, made of its kind and a key; other characters than letters and digits become underscores.
inline std::string FigureName(const std::string& kind, const std::string& key) {
  std::string name = kind + "_";
  for (const char c : key) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

/// Gnuplot command that sets the range of an axis to the values, with a margin of 5 % on both sides.
inline std::string RangeCommand(const char* axis, double least, double most) {
  const double span = most > least ? most - least : std::max(std::abs(most), 1.0);
  return fmt::format("set {} [{}:{}]\n", axis, Number(least - 0.05 * span), Number(most + 0.05 * span));
}

}  // namespace touchdown::sweeper
