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

/// A sweep's results: sweep.db in its folder, an SQLite database (tables: docs/sweeps.md). Rows are there
/// whole or not at all, whatever ends the program or the machine. All members throw InputError, naming the file, when
/// it cannot be read or written, is damaged, or is no sweep's of this version.
class SweepStore {
 public:
  enum class Access { kRead, kWrite };

  /// With kWrite it is made when it is not there.
  SweepStore(const std::filesystem::path& folder, Access access);
  ~SweepStore();

  /// Replaces the plan. Rows of flights that it does not hold stay, and do not count.
  void SetPlan(const SweepSpec& terms, const SweepPlan& plan, const std::string& program_digest);

  /// A row of the same id is replaced, but not a flown one by one whose process crashed, hung or ran out of memory.
  void Put(const FlightRow& row);
  /// All of them, or none.
  void Put(std::span<const FlightRow> rows);
  /// As Put; false when another program reads the file for so long that it cannot be written now.
  bool TryPut(const FlightRow& row);

  std::optional<FlightRow> Find(const std::string& id) const;

  /// Whether one was ever set.
  bool has_plan() const;
  /// Of the plan that was set last.
  SweepSpec terms() const;
  /// Digest of the program that planned.
  std::string program() const;
  std::size_t planned() const;
  /// Flights of the whole sweep, of which the plan may be a part.
  std::size_t whole() const;
  /// Without what is not kept of it: the flights' scenarios, lengths and limits.
  SweepPlan Plan() const;
  /// What is flown of the plan, in its order.
  std::vector<SweepResult> Results() const;
  /// Rows that another build flew.
  std::size_t stale() const;
  /// Rows that this build flew and the plan does not hold: the sweep's file was another then.
  std::size_t unplanned() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchdown::sweeper
