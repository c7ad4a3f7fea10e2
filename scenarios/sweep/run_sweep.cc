#include "scenarios/sweep/run_sweep.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "models/error.h"
#include "scenarios/flight/program_digest.h"
#include "scenarios/sweep/crew.h"
#include "scenarios/sweep/folder_lock.h"

namespace touchdown::scenarios {
namespace {

namespace fs = std::filesystem;

/// Makes the folder, or sees that what is in it is a sweep's.
void ClaimFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
  if (fs::exists(folder / "sweep.db")) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() != ".lock") {
      throw InputError(fmt::format("output folder {}: is not empty, and no sweep's", folder.string()));
    }
  }
}

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

  const FlightTask* Next() { return IsDecided() || next_ == tasks_.size() ? nullptr : &tasks_[next_++]; }

  void Take(const FlightRow& row) {
    passed_[row.id] = row.passed();
    Decide();
  }

  bool IsDecided() const { return test_ && test_->decision() != SequentialTest::Decision::kOpen; }
  /// As many flights, from the plan's start, as the decision took; all without one.
  std::size_t counted() const { return IsDecided() ? static_cast<std::size_t>(test_->taken()) : plan_.flights.size(); }
  bool IsDone() const { return IsDecided() || Progress().done == Progress().planned; }

  SweepProgress Progress() const {
    SweepProgress progress{.planned = static_cast<int>(plan_.flights.size())};
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

}  // namespace

SweepPlan ShardOf(const SweepPlan& plan, int shard, int shards) {
  SweepPlan part{.keys = plan.keys, .flights = {}};
  for (const PlannedFlight& flight : plan.flights) {
    if (flight.position % shards == shard) part.flights.push_back(flight);
  }
  return part;
}

void TakeInRows(const fs::path& folder, SweepStore& store) {
  const RowFolder rows(folder);
  for (const auto& entry : fs::directory_iterator(rows.rows())) {
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::optional<FlightRow> row = RowFromJson({std::istreambuf_iterator<char>(stream), {}});
    if (row) store.Put(*row);
    RemoveRow(entry.path());  // Else it is what a process left that was ended while it wrote.
  }
}

bool RunSweep(const SweepFile& file, const SweepPlan& plan, const fs::path& folder, int jobs,
              const StopRequested& stop_requested, const std::function<void(const SweepProgress&)>& progress) {
  ClaimFolder(folder);
  const FolderLock lock(folder);
  SweepStore store(folder, SweepStore::Access::kWrite);
  TakeInRows(folder, store);
  store.SetPlan(TermsOf(file), plan, ProgramDigest());
  Agenda agenda(file, plan, store);
  if (progress) progress(agenda.Progress());

  const RowFolder rows(folder);
  const CrewOptions crew{.jobs = jobs,
                         .fly = [&rows](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, rows); }};
  const auto keep = [&](const FlightRow& row) {
    store.Put(row);
    RemoveRow(rows.RowOf(row.id));
    agenda.Take(row);
    if (progress) progress(agenda.Progress());
  };
  FlyTasks(
      rows, crew, [&] { return agenda.Next(); }, keep, stop_requested);
  if (agenda.IsDecided()) store.SetPlan(TermsOf(file), FirstOf(plan, agenda.counted()), ProgramDigest());
  return agenda.IsDone();
}

}  // namespace touchdown::scenarios
