#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/runner/metrics.h"

namespace touchdown::sweeper {

/// How the process that flew ended.
enum class RowEnd {
  kFlown,        ///< With a flight's result, whatever its verdict.
  kCrashed,      ///< By a signal, or without leaving a result: the program itself failed.
  kHung,         ///< It took longer than its limit.
  kOutOfMemory,  ///< It needed more than its limit, or the system ended it (SIGKILL).
};
inline constexpr std::array<std::string_view, 4> kRowEndNames = {"flown", "crashed", "hung", "out_of_memory"};
constexpr std::string_view Name(RowEnd end) { return kRowEndNames[static_cast<std::size_t>(end)]; }
/// nullopt for what is no end's name.
std::optional<RowEnd> RowEndFrom(std::string_view name);

/// What is kept of a flight of a sweep.
struct FlightRow {
  std::string id = {};
  std::string program = {};  ///< Digest of the program that flew it.
  std::string version = {};
  std::string host = {};
  RowEnd end = RowEnd::kCrashed;
  std::string verdict = "error";  ///< "pass", "fail" or "error".
  std::string outcome = "error";  ///< As in result.json.
  std::string reason = {};        ///< In a few words, why it ended so.
  std::string failed_check = {};  ///< The first criterion that was not kept; empty when all were.
  std::string failed_phase = {};  ///< The phase of the flight in which that happened.
  runner::Metrics metrics = {};
  std::string log_sha256 = {};
  double wall_s = 0.0;
  std::string complaint = {};  ///< What the process said on stderr: its last lines.
  std::string scenario_yaml = {};

  bool passed() const { return verdict == "pass"; }
};

/// A flight of the sweep as it is planned now, with what was flown of it.
struct SweepResult {
  std::uint64_t seed = 0;
  std::string variant = {};
  std::vector<std::string> values = {};  ///< As YAML, in the order of the plan's keys.
  FlightRow row = {};
};

std::string RowJson(const FlightRow& row);
/// nullopt for a text that is no row.
std::optional<FlightRow> RowFromJson(const std::string& text);

}  // namespace touchdown::sweeper
