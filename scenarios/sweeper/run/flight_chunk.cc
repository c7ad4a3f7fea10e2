#include "scenarios/sweeper/run/flight_chunk.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <string.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "models/error.h"
#include "scenarios/util/file.h"
#include "scenarios/util/output_file.h"
#include "scenarios/util/program_digest.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kChunkSignature = "\"program\"";

/// Folder of incomplete rows: files in the sweep's folder of rows may be collected at any time.
class Bench {
 public:
  Bench(const fs::path& folder, int number) : place_((folder / "tasks" / fmt::format("{}.XXXXXX", number)).string()) {
    if (mkdtemp(place_.data()) == nullptr) {
      throw InputError(fmt::format("output folder {}: {}", folder.string(), strerror(errno)));
    }
  }
  ~Bench() {
    std::error_code ignored;
    fs::remove_all(place_, ignored);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  const std::string& place() const { return place_; }

 private:
  std::string place_;
};

FlightChunk ReadChunk(const fs::path& file) {
  const std::string text = util::ReadTextFile(file);
  try {
    const Json json = Json::parse(text);
    FlightChunk chunk{.program = json.at("program"), .flights = {}};
    for (const Json& flight : json.at("flights")) {
      chunk.flights.push_back({.id = flight.at("id"),
                               .scenario_yaml = flight.at("scenario"),
                               .limit_s = flight.at("limit_s"),
                               .memory_mb = flight.at("memory_mb")});
    }
    return chunk;
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}: is no chunk of a sweep", file.string()));
  }
}

void Move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw InputError(fmt::format("{}: {}", to.string(), error.message()));
}

/// Leaves a row and its picture with the others, but no failure where another copy of the task has flown.
void HandOver(const RowFolder& from, const RowFolder& to, const FlightRow& row) {
  const std::optional<FlightRow> there = ReadRowOrSetAside(to.RowOf(row.id));
  if (there && there->process == ProcessEnd::kFlown && row.process != ProcessEnd::kFlown) return;
  if (fs::exists(from.PictureOf(row.id))) Move(from.PictureOf(row.id), to.PictureOf(row.id));
  Move(from.RowOf(row.id), to.RowOf(row.id));
}

}  // namespace

fs::path ChunkFile(const fs::path& folder, int number) { return folder / "tasks" / fmt::format("{}.json", number); }

void WriteChunk(const fs::path& file, const FlightChunk& chunk) {
  Json json{{"program", chunk.program}, {"flights", Json::array()}};
  for (const FlightTask& flight : chunk.flights) {
    json["flights"].push_back({{"id", flight.id},
                               {"scenario", flight.scenario_yaml},
                               {"limit_s", flight.limit_s},
                               {"memory_mb", flight.memory_mb}});
  }
  util::WriteOutputFile(file, json.dump(1) + "\n", kChunkSignature);
}

bool FlyChunk(const fs::path& folder, int number, int jobs, const util::StopRequested& stop_requested,
              const OnRow& on_row) {
  const fs::path file = ChunkFile(folder, number);
  const FlightChunk chunk = ReadChunk(file);
  if (chunk.program != util::ProgramDigest()) {
    throw InputError(fmt::format("{}: was planned by another build than this program", file.string()));
  }
  const Bench bench(folder, number);
  const RowFolder unfinished(bench.place()), rows(folder);
  auto at = chunk.flights.begin();
  const auto next = [&]() -> const FlightTask* {
    while (at != chunk.flights.end() && rows.Find(at->id)) ++at;
    return at == chunk.flights.end() ? nullptr : &*at++;
  };
  const ProcessPoolOptions crew{
      .jobs = jobs, .fly = [&](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, unfinished); }};
  const auto keep = [&](const FlightRow& row) {
    HandOver(unfinished, rows, row);
    on_row(row);
  };
  FlyTasks(unfinished, crew, next, keep, stop_requested);
  return at == chunk.flights.end();
}

}  // namespace touchdown::sweeper
