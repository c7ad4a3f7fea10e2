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

/// Results of a sweep: sweep.db in its folder, an SQLite database (tables: docs/sweeps.md). A row is stored completely
/// or not at all, even if the program or the machine stops. All members throw InputError, naming the file, when it
/// cannot be read or written, is damaged, or is not a sweep database of this version.
class SweepStore {
 public:
  enum class Access { kRead, kWrite };

  /// kWrite creates the file when it does not exist.
  SweepStore(const std::filesystem::path& folder, Access access);
  ~SweepStore();

  /// Replaces the plan. Rows of other flights are kept, and do not count.
  void SetPlan(const SweepSpec& terms, const SweepPlan& plan, const std::string& program_digest);

  /// Stores a row. It replaces a row of the same id, unless that one is flown and the new one crashed, hung or ran out
  /// of memory.
  void Put(const FlightRow& row);
  /// Stores all rows, or none.
  void Put(std::span<const FlightRow> rows);
  /// Same as Put; returns false when another program locks the file for too long.
  bool TryPut(const FlightRow& row);

  std::optional<FlightRow> Find(const std::string& id) const;

  /// Whether a plan was ever set.
  bool has_plan() const;
  /// Keys of the newest plan.
  SweepSpec terms() const;
  /// Digest of the program that made the plan.
  std::string program() const;
  std::size_t planned() const;
  /// Flights of the whole sweep; the plan may be a part of it.
  std::size_t whole() const;
  /// The plan without scenarios, durations and limits, which are not stored.
  SweepPlan Plan() const;
  /// Flown flights of the plan, in its order.
  std::vector<SweepResult> Results() const;
  /// Number of rows of other builds.
  std::size_t stale() const;
  /// Number of rows of this build that are not in the plan, e.g. of an earlier version of the sweep file.
  std::size_t unplanned() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sweeper
