#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenarios/sweeper/plan/flight_row.h"
#include "scenarios/sweeper/plan/sweep_plan.h"
#include "scenarios/sweeper/plan/sweep_spec.h"

namespace touchdown::sweeper {

/// Results of a sweep in the SQLite database sweep.db of its output directory (tables: docs/sweeps.md). A row is stored
/// completely or not at all, even if the program or the machine stops. All members throw InputError, naming the file,
/// if it cannot be read or written, is damaged, or is not a sweep database of this version.
class SweepStore {
 public:
  enum class Access { kRead, kWrite };

  /// Opens the database. kWrite creates the file if it does not exist.
  SweepStore(const std::filesystem::path& folder, Access access);
  ~SweepStore();

  /// Replaces the specification and the plan. Rows of flights that are not in the plan are kept, but not counted.
  void SetPlan(const SweepSpec& spec, const SweepPlan& plan, const std::string& program_digest);

  /// Stores a row. It replaces a stored row with the same id, unless the stored flight was flown and the process of the
  /// new one crashed, hung or ran out of memory.
  void Put(const FlightRow& row);
  /// Stores all rows, or none.
  void Put(std::span<const FlightRow> rows);
  /// Like Put, but returns false if another program locks the file for too long.
  bool TryPut(const FlightRow& row);

  /// Row of a flight; nullopt if there is none.
  std::optional<FlightRow> Find(const std::string& id) const;

  /// Whether the database contains a plan.
  bool has_plan() const;
  /// Specification of the sweep; empty without a plan.
  SweepSpec spec() const;
  /// Digest of the program that made the plan.
  std::string program() const;
  /// Number of planned flights.
  std::size_t planned() const;
  /// Number of flights of the whole sweep, of which the plan may be a part.
  std::size_t total() const;
  /// The plan, without scenarios, durations and limits, which are not stored.
  SweepPlan Plan() const;
  /// Planned flights that have a row, in the order of the plan.
  std::vector<SweepResult> Results() const;
  /// Number of rows of other builds.
  std::size_t stale() const;
  /// Number of rows of this build that are not in the plan, for example from an earlier version of the sweep file.
  std::size_t unplanned() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sweeper
