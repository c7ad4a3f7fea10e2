#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/runner/metrics.h"
#include "scenarios/runner/verdict.h"

namespace touchdown::sweeper {

/// End of the process that flew a flight.
enum class ProcessEnd {
  kFlown,        ///< It wrote a result, with any verdict.
  kCrashed,      ///< It ended by a signal or without a result, because the program itself failed.
  kHung,         ///< It exceeded the time limit.
  kOutOfMemory,  ///< It exceeded the memory limit, or the system killed it (SIGKILL).
};
inline constexpr std::array<std::string_view, 4> kProcessEndNames = {"flown", "crashed", "hung", "out_of_memory"};
constexpr const auto& NamesOf(ProcessEnd) { return kProcessEndNames; }
constexpr std::string_view Name(ProcessEnd end) { return kProcessEndNames[static_cast<std::size_t>(end)]; }

/// Stored result of a flight of a sweep.
struct FlightRow {
  std::string id = {};
  std::string program = {};  ///< Digest of the program that flew it.
  std::string version = {};
  std::string host = {};
  ProcessEnd process = ProcessEnd::kCrashed;
  runner::Verdict verdict = runner::Verdict::kError;
  runner::Outcome outcome = runner::Outcome::kError;
  std::string reason = {};        ///< Reason for the outcome, in a few words.
  std::string failed_check = {};  ///< The first check that the flight did not meet; empty if it met all.
  std::string failed_phase = {};  ///< Phase of the flight in which this check failed.
  runner::Metrics metrics = {};
  std::string log_sha256 = {};
  double wall_s = 0.0;
  std::string stderr_tail = {};  ///< The last lines that the process wrote to stderr.
  std::string scenario = {};     ///< The resolved scenario, YAML.

  bool passed() const { return verdict == runner::Verdict::kPass; }
};

/// Calls `visit(name, value)` for each column of a row except its metrics. The names are the columns of the table
/// `flights` in sweep.db, in this order, and the keys of a row file. The first is the primary key. `Row` is FlightRow
/// or const FlightRow.
template <typename Row, typename Visit>
void VisitColumns(Row& row, const Visit& visit) {
  visit("id", row.id);
  visit("program", row.program);
  visit("version", row.version);
  visit("host", row.host);
  visit("process", row.process);
  visit("verdict", row.verdict);
  visit("outcome", row.outcome);
  visit("reason", row.reason);
  visit("failed_check", row.failed_check);
  visit("failed_phase", row.failed_phase);
  visit("log_sha256", row.log_sha256);
  visit("wall_s", row.wall_s);
  visit("stderr_tail", row.stderr_tail);
  visit("scenario", row.scenario);
}

/// A planned flight of the sweep, with its row.
struct SweepResult {
  std::uint64_t seed = 0;
  std::string variant = {};
  std::vector<std::string> values = {};  ///< Parameter values as YAML, in the order of the plan's keys.
  FlightRow row = {};
};

/// Contents of a row file.
std::string RowJson(const FlightRow& row);
/// Parses a row file; nullopt for text that is not a row of this version.
std::optional<FlightRow> RowFromJson(const std::string& text);

}  // namespace touchdown::sweeper
