#include "scenarios/sweeper/run/run_sweep.h"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <system_error>

#include "models/error.h"
#include "scenarios/sweeper/run/process_pool.h"
#include "scenarios/util/folder_lock.h"
#include "scenarios/util/program_digest.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

/// State of the planned flights, and queue of the flights to fly.
class FlightQueue {
 public:
  FlightQueue(const SweepFile& file, const SweepPlan& plan, const SweepStore& store, bool retry) : plan_(plan) {
    if (file.stop_when) test_.emplace(*file.stop_when);
    progress_.planned = static_cast<int>(plan.flights.size());
    for (const PlannedFlight& flight : plan.flights) {
      expected_s_[flight.id] = flight.expected_s;
      total_s_ += flight.expected_s;
      const auto row = store.Find(flight.id);
      if (row && !(retry && row->process != ProcessEnd::kFlown)) {
        Count(*row);
      } else {
        tasks_.push_back({flight.id, flight.scenario_yaml, flight.limit_s, file.limits.memory_mb});
      }
    }
    Decide();
  }

  /// Next flight; nullptr if none is left or the test has decided.
  const FlightTask* Next() {
    if (!HasNext()) return nullptr;
    ++progress_.flying;
    return &tasks_[next_++];
  }

  bool HasNext() const { return !IsDecided() && next_ < tasks_.size(); }

  /// Records the row of a flight that has ended.
  void Record(const FlightRow& row) {
    --progress_.flying;
    Count(row);
    Decide();
  }

  bool IsDecided() const { return test_ && test_->decision() != SequentialTest::Decision::kOpen; }
  /// Number of flights up to the decision, in the order of the plan; all flights without a decision.
  std::size_t counted() const {
    return IsDecided() ? static_cast<std::size_t>(test_->outcomes()) : plan_.flights.size();
  }
  bool IsDone() const { return IsDecided() || progress_.done == progress_.planned; }

  SweepProgress Progress() const {
    SweepProgress progress = progress_;
    progress.fraction = total_s_ > 0.0 ? done_s_ / total_s_ : 1.0;
    return progress;
  }

 private:
  void Count(const FlightRow& row) {
    passed_[row.id] = row.passed();
    ++progress_.done;
    progress_.passed += row.passed() ? 1 : 0;
    done_s_ += expected_s_.at(row.id);
  }

  /// Adds outcomes to the test, in the order of the plan, up to the first missing one.
  void Decide() {
    if (!test_) return;
    for (; decided_ < plan_.flights.size() && !IsDecided(); ++decided_) {
      const auto found = passed_.find(plan_.flights[decided_].id);
      if (found == passed_.end()) return;
      test_->Add(found->second);
    }
  }

  const SweepPlan& plan_;
  std::optional<SequentialTest> test_;
  std::map<std::string, double> expected_s_;
  std::map<std::string, bool> passed_;
  std::vector<FlightTask> tasks_;
  std::size_t next_ = 0, decided_ = 0;
  SweepProgress progress_;
  double done_s_ = 0.0, total_s_ = 0.0;
};

SweepPlan FirstOf(const SweepPlan& plan, std::size_t count) {
  SweepPlan first = plan;
  first.flights.resize(count);
  first.total = count;
  return first;
}

void RemoveRow(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

bool IsRow(const fs::path& file) { return file.extension() == ".json"; }

/// Whether a file is a partial file of a process that was killed: it has not changed for ten minutes.
bool IsAbandoned(const fs::directory_entry& entry) {
  std::error_code gone;
  const fs::file_time_type written = entry.last_write_time(gone);
  return !gone && entry.path().filename().string().find(".partial-") != std::string::npos &&
         fs::file_time_type::clock::now() - written > std::chrono::minutes(10);
}

/// Entries of a folder. Throws InputError if it cannot be read.
std::vector<fs::directory_entry> EntriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(*at);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  return entries;
}

}  // namespace

SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards) {
  SweepPlan part{.keys = plan.keys, .flights = {}, .total = plan.total};
  int first = 0, to = 0;  // Shards of the first flight of the seed, and of this flight.
  for (std::size_t i = 0; i < plan.flights.size(); ++i) {
    if (i > 0 && plan.flights[i].seed != plan.flights[i - 1].seed) to = first = (first + 1) % shards;
    if (to == shard) part.flights.push_back(plan.flights[i]);
    to = (to + 1) % shards;
  }
  return part;
}

std::vector<FlightRow> UncollectedRows(const fs::path& folder) {
  std::vector<FlightRow> rows;
  std::error_code error;
  if (!fs::exists(folder / "rows", error)) return rows;
  for (const auto& entry : EntriesOf(folder / "rows")) {
    if (!IsRow(entry.path())) continue;
    if (auto row = ReadRow(entry.path())) rows.push_back(std::move(*row));
  }
  return rows;
}

void CollectRows(const fs::path& folder, SweepStore& store) {
  std::vector<FlightRow> rows;
  std::vector<fs::path> files;
  for (const auto& entry : EntriesOf(RowFolder(folder).rows())) {
    if (IsAbandoned(entry)) RemoveRow(entry.path());
    if (!IsRow(entry.path())) continue;
    if (std::optional<FlightRow> row = ReadRowOrSetAside(entry.path())) {
      rows.push_back(std::move(*row));
      files.push_back(entry.path());
    }
  }
  store.Put(rows);
  for (const fs::path& file : files) RemoveRow(file);
}

bool RunSweep(const SweepFile& file, const SweepPlan& plan, const fs::path& folder, const SweepOptions& options,
              const util::StopRequested& stop_requested, const std::function<void(const SweepProgress&)>& progress) {
  util::ClaimFolder(folder);
  const util::FolderLock lock(folder);
  SweepStore store(folder, SweepStore::Access::kWrite);
  CollectRows(folder, store);
  store.SetPlan(SpecOf(file), plan, util::ProgramDigest());
  FlightQueue queue(file, plan, store, options.retry);
  if (progress) progress(queue.Progress());

  const RowFolder rows(folder);
  const ProcessPoolOptions pool_options{
      .jobs = options.jobs, .fly = [&rows](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, rows); }};
  const auto next = [&] {
    const FlightTask* const task = queue.Next();
    if (task != nullptr && progress) progress(queue.Progress());
    return task;
  };
  const auto store_row = [&](const FlightRow& row) {
    // If the database is locked, CollectRows stores the row at the end.
    if (store.TryPut(row)) RemoveRow(rows.RowFile(row.id));
    queue.Record(row);
    const bool another_starts = queue.HasNext() && !(stop_requested && stop_requested());
    if (progress && !another_starts) progress(queue.Progress());
  };
  FlyTasks(rows, pool_options, next, store_row, stop_requested);
  CollectRows(folder, store);
  if (queue.IsDecided()) store.SetPlan(SpecOf(file), FirstOf(plan, queue.counted()), util::ProgramDigest());
  return queue.IsDone();
}

}  // namespace touchdown::sweeper
