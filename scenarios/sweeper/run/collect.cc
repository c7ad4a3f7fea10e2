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

/// A sweep, or some of its flights, as a folder has it.
struct Part {
  fs::path folder;
  SweepSpec terms;
  std::string program;
  SweepPlan plan;
};

Part PartIn(const fs::path& folder, const SweepStore& store) {
  return {folder, store.terms(), store.program(), store.Plan()};
}

Part ReadPart(const fs::path& folder) {
  const SweepStore store(folder, SweepStore::Access::kRead);
  if (!store.has_plan()) throw InputError(fmt::format("{}: has no plan of a sweep yet", folder.string()));
  return PartIn(folder, store);
}

/// All parts' flights, by position.
SweepPlan Join(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  SweepPlan whole{.keys = first.plan.keys, .flights = {}, .whole = 0};
  std::map<std::int64_t, PlannedFlight> flights;
  for (const Part& part : parts) {
    whole.whole = std::max(whole.whole, part.plan.whole);
    const auto refuse = [&](const std::string& why) { throw InputError(part.folder.string() + ": " + why); };
    if (part.terms.name != first.terms.name) {
      refuse(
          fmt::format("is of sweep {}, and {} of sweep {}", part.terms.name, first.folder.string(), first.terms.name));
    }
    if (part.program != first.program) refuse(fmt::format("is of another build than {}", first.folder.string()));
    for (const PlannedFlight& flight : part.plan.flights) {
      if (part.plan.keys != first.plan.keys || flights.emplace(flight.position, flight).first->second.id != flight.id) {
        refuse(fmt::format("plans other flights than {}, under the same name", first.folder.string()));
      }
    }
  }
  for (const auto& [position, flight] : flights) whole.flights.push_back(flight);
  return whole;
}

/// Earlier collections may be judged again, and the parts must have the same specification.
void RefuseOtherTerms(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (TermsJson(part.terms) == TermsJson(parts.front().terms)) continue;
    throw InputError(fmt::format("{}: was flown for another version of the sweep's file than {}", part.folder.string(),
                                 parts.front().folder.string()));
  }
}

std::vector<FlightRow> RowsOf(const Part& part) {
  std::vector<FlightRow> rows = LeftRows(part.folder);
  for (SweepResult& result : SweepStore(part.folder, SweepStore::Access::kRead).Results()) {
    rows.push_back(std::move(result.row));
  }
  std::erase_if(rows, [&](const FlightRow& row) { return row.program != part.program; });
  return rows;
}

/// Parts of one sweep.
std::vector<Part> ReadParts(const std::vector<fs::path>& folders) {
  std::vector<Part> parts;
  for (const fs::path& folder : folders) parts.push_back(ReadPart(folder));
  Join(parts);
  RefuseOtherTerms(parts);
  return parts;
}

void CopyPictures(const fs::path& from, const fs::path& to) {
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
  const SweepPlan whole = Join(parts);
  TakeInRows(folder, store);
  if (from.empty()) return;
  std::vector<FlightRow> rows;
  for (const Part& part : parts) {
    if (fs::equivalent(part.folder, folder)) continue;
    std::ranges::move(RowsOf(part), std::back_inserter(rows));
    CopyPictures(part.folder, folder);
  }
  store.Put(rows);
  store.SetPlan(parts.front().terms, whole, parts.front().program);
}

}  // namespace touchdown::sweeper
