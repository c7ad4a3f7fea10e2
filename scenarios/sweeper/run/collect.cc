#include "scenarios/sweeper/run/collect.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <system_error>

#include "models/error.h"
#include "scenarios/sweeper/run/run_sweep.h"
#include "scenarios/util/folder_lock.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;

/// A sweep, or a part of it, in an output directory.
struct Part {
  fs::path folder;
  SweepSpec spec;
  std::string program;
  SweepPlan plan;
};

Part PartIn(const fs::path& folder, const SweepStore& store) {
  return {folder, store.spec(), store.program(), store.Plan()};
}

Part ReadPart(const fs::path& folder) {
  const SweepStore store(folder, SweepStore::Access::kRead);
  if (!store.has_plan()) throw InputError(fmt::format("{}: contains no plan of a sweep yet", folder.string()));
  return PartIn(folder, store);
}

/// Merges the plans of the parts, ordered by position. Throws InputError if they are not parts of the same sweep.
SweepPlan Join(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  SweepPlan merged{.keys = first.plan.keys, .flights = {}, .total = 0};
  std::map<std::int64_t, PlannedFlight> flights;
  for (const Part& part : parts) {
    merged.total = std::max(merged.total, part.plan.total);
    const auto reject = [&](const std::string& why) { throw InputError(part.folder.string() + ": " + why); };
    if (part.spec.name != first.spec.name) {
      reject(fmt::format("contains sweep {}, but {} contains sweep {}", part.spec.name, first.folder.string(),
                         first.spec.name));
    }
    if (part.program != first.program)
      reject(fmt::format("contains a sweep of another build than {}", first.folder.string()));
    for (const PlannedFlight& flight : part.plan.flights) {
      if (part.plan.keys != first.plan.keys || flights.emplace(flight.position, flight).first->second.id != flight.id) {
        reject(fmt::format("contains other flights than {}, with the same sweep name", first.folder.string()));
      }
    }
  }
  for (const auto& [position, flight] : flights) merged.flights.push_back(flight);
  return merged;
}

/// Throws InputError if the specifications of the parts differ. An earlier collection may have another specification.
void RejectOtherSpecs(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (SpecJson(part.spec) == SpecJson(parts.front().spec)) continue;
    throw InputError(fmt::format("{}: contains another version of the sweep file than {}", part.folder.string(),
                                 parts.front().folder.string()));
  }
}

/// Rows of a part, including its row files, without those of other builds.
std::vector<FlightRow> RowsOf(const Part& part) {
  std::vector<FlightRow> rows = UncollectedRows(part.folder);
  for (SweepResult& result : SweepStore(part.folder, SweepStore::Access::kRead).Results()) {
    rows.push_back(std::move(result.row));
  }
  std::erase_if(rows, [&](const FlightRow& row) { return row.program != part.program; });
  return rows;
}

/// Reads the parts of a sweep. Throws InputError if they do not belong together.
std::vector<Part> ReadParts(const std::vector<fs::path>& folders) {
  std::vector<Part> parts;
  for (const fs::path& folder : folders) parts.push_back(ReadPart(folder));
  Join(parts);
  RejectOtherSpecs(parts);
  return parts;
}

void CopyImages(const fs::path& from, const fs::path& to) {
  if (!fs::exists(from / "pictures")) return;
  std::error_code error;
  fs::create_directories(to / "pictures", error);
  if (!error) {
    fs::copy(from / "pictures", to / "pictures", fs::copy_options::recursive | fs::copy_options::overwrite_existing,
             error);
  }
  if (error) throw InputError(fmt::format("output folder {}: {}", to.string(), error.message()));
}

}  // namespace

void Collect(const fs::path& folder, const std::vector<fs::path>& from) {
  std::vector<Part> parts = ReadParts(from.empty() ? std::vector{folder} : from);
  util::ClaimFolder(folder);
  const util::FolderLock lock(folder);
  SweepStore store(folder, SweepStore::Access::kWrite);
  if (!from.empty() && store.has_plan()) parts.push_back(PartIn(folder, store));
  const SweepPlan merged = Join(parts);
  CollectRows(folder, store);
  if (from.empty()) return;
  std::vector<FlightRow> rows;
  for (const Part& part : parts) {
    if (fs::equivalent(part.folder, folder)) continue;
    std::ranges::move(RowsOf(part), std::back_inserter(rows));
    CopyImages(part.folder, folder);
  }
  store.Put(rows);
  store.SetPlan(parts.front().spec, merged, parts.front().program);
}

}  // namespace touchdown::sweeper
