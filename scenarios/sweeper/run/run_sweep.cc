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

/// State of the planned flights, and the queue of flights to fly.
class FlightQueue {
 public:
  FlightQueue(const SweepFile& file, const SweepPlan& plan, const SweepStore& store, bool retry) : plan_(plan) {
    if (file.stop_when) test_.emplace(*file.stop_when);
    progress_.planned = static_cast<int>(plan.flights.size());
    for (const PlannedFlight& flight : plan.flights) {
      expected_s_[flight.id] = flight.expected_s;
      whole_s_ += flight.expected_s;
      const auto row = store.Find(flight.id);
      if (row && !(retry && row->process != ProcessEnd::kFlown)) {
        Count(*row);
      } else {
        tasks_.push_back({flight.id, flight.scenario_yaml, flight.limit_s, file.limits.memory_mb});
      }
    }
    Decide();
  }

  const FlightTask* Next() {
    if (!HasNext()) return nullptr;
    ++progress_.flying;
    return &tasks_[next_++];
  }

  bool HasNext() const { return !IsDecided() && next_ < tasks_.size(); }

  void Take(const FlightRow& row) {
    --progress_.flying;
    Count(row);
    Decide();
  }

  bool IsDecided() const { return test_ && test_->decision() != SequentialTest::Decision::kOpen; }
  /// Number of flights, from the start of the plan, up to the decision; all without one.
  std::size_t counted() const { return IsDecided() ? static_cast<std::size_t>(test_->taken()) : plan_.flights.size(); }
  bool IsDone() const { return IsDecided() || progress_.done == progress_.planned; }

  SweepProgress Progress() const {
    SweepProgress progress = progress_;
    progress.share = whole_s_ > 0.0 ? done_s_ / whole_s_ : 1.0;
    return progress;
  }

 private:
  void Count(const FlightRow& row) {
    passed_[row.id] = row.passed();
    ++progress_.done;
    progress_.passed += row.passed() ? 1 : 0;
    done_s_ += expected_s_.at(row.id);
  }

  /// Gives the test the outcomes that there are without a gap.
  void Decide() {
    if (!test_) return;
    for (; decided_ < plan_.flights.size() && !IsDecided(); ++decided_) {
      const auto found = passed_.find(plan_.flights[decided_].id);
      if (found == passed_.end()) return;
      test_->Take(found->second);
    }
  }

  const SweepPlan& plan_;
  std::optional<SequentialTest> test_;
  std::map<std::string, double> expected_s_;
  std::map<std::string, bool> passed_;
  std::vector<FlightTask> tasks_;
  std::size_t next_ = 0, decided_ = 0;
  SweepProgress progress_;
  double done_s_ = 0.0, whole_s_ = 0.0;
};

SweepPlan FirstOf(const SweepPlan& plan, std::size_t count) {
  SweepPlan first = plan;
  first.flights.resize(count);
  first.whole = count;
  return first;
}

void RemoveRow(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

bool IsRow(const fs::path& file) { return file.extension() == ".json"; }

/// Whether a process left it that was ended while it wrote, and none writes it now.
bool IsAbandoned(const fs::directory_entry& entry) {
  std::error_code gone;
  const fs::file_time_type written = entry.last_write_time(gone);
  return !gone && entry.path().filename().string().find(".partial-") != std::string::npos &&
         fs::file_time_type::clock::now() - written > std::chrono::minutes(10);
}

std::vector<fs::directory_entry> EntriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(*at);
  if (error) throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  return entries;
}

}  // namespace

SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards) {
  SweepPlan part{.keys = plan.keys, .flights = {}, .whole = plan.whole};
  int first = 0, to = 0;  // The shards that the seed's first flight, and this one, belong to.
  for (std::size_t i = 0; i < plan.flights.size(); ++i) {
    if (i > 0 && plan.flights[i].seed != plan.flights[i - 1].seed) to = first = (first + 1) % shards;
    if (to == shard) part.flights.push_back(plan.flights[i]);
    to = (to + 1) % shards;
  }
  return part;
}

std::vector<FlightRow> LeftRows(const fs::path& folder) {
  std::vector<FlightRow> left;
  std::error_code error;
  if (!fs::exists(folder / "rows", error)) return left;
  for (const auto& entry : EntriesOf(folder / "rows")) {
    if (!IsRow(entry.path())) continue;
    if (auto row = ReadRow(entry.path())) left.push_back(std::move(*row));
  }
  return left;
}

void TakeInRows(const fs::path& folder, SweepStore& store) {
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
  TakeInRows(folder, store);
  store.SetPlan(TermsOf(file), plan, util::ProgramDigest());
  FlightQueue queue(file, plan, store, options.retry);
  if (progress) progress(queue.Progress());

  const RowFolder rows(folder);
  const ProcessPoolOptions crew{.jobs = options.jobs,
                                .fly = [&rows](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, rows); }};
  const auto next = [&] {
    const FlightTask* const task = queue.Next();
    if (task != nullptr && progress) progress(queue.Progress());
    return task;
  };
  const auto keep = [&](const FlightRow& row) {
    if (store.TryPut(row)) RemoveRow(rows.RowOf(row.id));  // Else it is taken in at the end.
    queue.Take(row);
    const bool another_starts = queue.HasNext() && !(stop_requested && stop_requested());
    if (progress && !another_starts) progress(queue.Progress());
  };
  FlyTasks(rows, crew, next, keep, stop_requested);
  TakeInRows(folder, store);
  if (queue.IsDecided()) store.SetPlan(TermsOf(file), FirstOf(plan, queue.counted()), util::ProgramDigest());
  return queue.IsDone();
}

}  // namespace touchdown::sweeper
