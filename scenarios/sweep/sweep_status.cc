#include "scenarios/sweep/sweep_status.h"

#include "scenarios/sweep/run_sweep.h"
#include "scenarios/sweep/slurm.h"
#include "scenarios/sweep/slurm_sweep.h"

namespace touchdown::scenarios {

SweepStatus StatusOf(const std::filesystem::path& folder) {
  const SweepStore store(folder, SweepStore::Access::kRead);
  std::map<std::string, bool> passed;
  for (const FlightRow& row : LeftRows(folder)) passed[row.id] = row.passed();
  for (const SweepResult& result : store.Results()) passed[result.row.id] = result.row.passed();

  SweepStatus status{.name = store.terms().name, .stale = store.stale(), .slurm_job = SlurmJobOf(folder)};
  for (const PlannedFlight& flight : store.Plan().flights) {
    ++status.planned;
    const auto found = passed.find(flight.id);
    if (found == passed.end()) continue;
    ++status.flown;
    status.passed += found->second ? 1 : 0;
  }
  if (status.slurm_job) status.slurm_tasks = TasksInQueue(*status.slurm_job);
  return status;
}

}  // namespace touchdown::scenarios
