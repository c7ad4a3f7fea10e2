#include "scenarios/sweep/run_sweep.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "scenarios/flight/program_digest.h"
#include "scenarios/sweep/crew.h"
#include "scenarios/sweep/folder_lock.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

/// What is known of the planned flights, and what is to be flown next.
class Agenda {
 public:
  Agenda(const SweepFile& file, const SweepPlan& plan, const SweepStore& store) : plan_(plan) {
    if (file.stop_when) test_.emplace(*file.stop_when);
    for (const PlannedFlight& flight : plan.flights) {
      whole_s_ += flight.expected_s;
      if (passed_.contains(flight.id)) continue;
      if (const auto row = store.Find(flight.id)) {
        passed_[flight.id] = row->passed();
      } else if (wanted_.insert(flight.id).second) {
        tasks_.push_back({flight.id, flight.scenario_yaml, flight.limit_s, file.limits.memory_mb});
      }
    }
    Decide();
  }

  const FlightTask* Next() {
    if (!HasNext()) return nullptr;
    ++flying_;
    return &tasks_[next_++];
  }

  bool HasNext() const { return !IsDecided() && next_ < tasks_.size(); }

  void Take(const FlightRow& row) {
    --flying_;
    passed_[row.id] = row.passed();
    Decide();
  }

  bool IsDecided() const { return test_ && test_->decision() != SequentialTest::Decision::kOpen; }
  /// As many flights, from the plan's start, as the decision took; all without one.
  std::size_t counted() const { return IsDecided() ? static_cast<std::size_t>(test_->taken()) : plan_.flights.size(); }
  bool IsDone() const { return IsDecided() || Progress().done == Progress().planned; }

  SweepProgress Progress() const {
    SweepProgress progress{.planned = static_cast<int>(plan_.flights.size()), .flying = flying_};
    double done_s = 0.0;
    for (const PlannedFlight& flight : plan_.flights) {
      const auto found = passed_.find(flight.id);
      if (found == passed_.end()) continue;
      ++progress.done;
      progress.passed += found->second ? 1 : 0;
      done_s += flight.expected_s;
    }
    progress.share = whole_s_ > 0.0 ? done_s / whole_s_ : 1.0;
    return progress;
  }

 private:
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
  std::map<std::string, bool> passed_;
  std::set<std::string> wanted_;
  std::vector<FlightTask> tasks_;
  std::size_t next_ = 0, decided_ = 0;
  int flying_ = 0;
  double whole_s_ = 0.0;
};

SweepPlan FirstOf(const SweepPlan& plan, std::size_t count) {
  SweepPlan first = plan;
  first.flights.resize(count);
  return first;
}

void RemoveRow(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

/// nullopt for what is no row, or none yet.
std::optional<FlightRow> RowIn(const fs::path& file) {
  if (file.extension() != ".json") return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  return RowFromJson({std::istreambuf_iterator<char>(stream), {}});
}

/// Whether a process left it that was ended while it wrote, and none writes it now.
bool IsAbandoned(const fs::directory_entry& entry) {
  std::error_code gone;
  const fs::file_time_type written = entry.last_write_time(gone);
  return !gone && fs::file_time_type::clock::now() - written > std::chrono::minutes(10);
}

}  // namespace

SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards) {
  SweepPlan part{.keys = plan.keys, .flights = {}};
  for (const PlannedFlight& flight : plan.flights) {
    if (flight.position % shards == shard) part.flights.push_back(flight);
  }
  return part;
}

std::vector<FlightRow> LeftRows(const fs::path& folder) {
  std::vector<FlightRow> left;
  if (!fs::exists(folder / "rows")) return left;
  for (const auto& entry : fs::directory_iterator(folder / "rows")) {
    if (auto row = RowIn(entry.path())) left.push_back(std::move(*row));
  }
  return left;
}

void TakeInRows(const fs::path& folder, SweepStore& store) {
  const RowFolder rows(folder);
  for (const auto& entry : fs::directory_iterator(rows.rows())) {
    const std::optional<FlightRow> row = RowIn(entry.path());
    if (row) store.Put(*row);
    if (row || IsAbandoned(entry)) RemoveRow(entry.path());
  }
}

bool RunSweep(const SweepFile& file, const SweepPlan& plan, const fs::path& folder, const SweepOptions& options,
              const StopRequested& stop_requested, const std::function<void(const SweepProgress&)>& progress) {
  ClaimFolder(folder);
  const FolderLock lock(folder);
  SweepStore store(folder, SweepStore::Access::kWrite);
  TakeInRows(folder, store);
  if (options.retry) store.ForgetUnflown(ProgramDigest());
  store.SetPlan(TermsOf(file), plan, ProgramDigest());
  Agenda agenda(file, plan, store);
  if (progress) progress(agenda.Progress());

  const RowFolder rows(folder);
  const CrewOptions crew{.jobs = options.jobs,
                         .fly = [&rows](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, rows); }};
  const auto next = [&] {
    const FlightTask* const task = agenda.Next();
    if (task != nullptr && progress) progress(agenda.Progress());
    return task;
  };
  const auto keep = [&](const FlightRow& row) {
    store.Put(row);
    RemoveRow(rows.RowOf(row.id));
    agenda.Take(row);
    if (progress && !agenda.HasNext()) progress(agenda.Progress());  // Else the next one's start tells of it.
  };
  FlyTasks(rows, crew, next, keep, stop_requested);
  if (agenda.IsDecided()) store.SetPlan(TermsOf(file), FirstOf(plan, agenda.counted()), ProgramDigest());
  return agenda.IsDone();
}

}  // namespace touchdown::scenarios
