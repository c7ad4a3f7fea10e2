#include "scenarios/sweeper/run/sweep_status.h"

#include "scenarios/sweeper/run/folder_rows.h"
#include "scenarios/sweeper/run/slurm.h"
#include "scenarios/sweeper/run/slurm_sweep.h"

namespace touchdown::sweeper {

SweepStatus StatusOf(const std::filesystem::path& folder) {
  const SweepStore store(folder, SweepStore::Access::kRead);
  const FolderRows rows(folder, &store);
  SweepStatus status{
      .name = store.spec().name, .total = store.total(), .stale = store.stale(), .slurm_job = SlurmJobOf(folder)};
  for (const PlannedFlight& flight : store.Plan().flights) {
    ++status.planned;
    const std::optional<FlightRow> row = rows.Find(flight.id);
    if (!row) continue;
    ++status.flown;
    status.passed += row->passed() ? 1 : 0;
    if (row->process != ProcessEnd::kFlown) ++status.processes[std::string(Name(row->process))];
  }
  if (status.slurm_job) status.slurm_tasks = TasksInQueue(*status.slurm_job);
  return status;
}

}  // namespace touchdown::sweeper
