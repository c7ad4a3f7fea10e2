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

/// Temporary folder of a task. Rows are written there first, because the row files of the sweep may be collected at any
/// time.
class TaskFolder {
 public:
  TaskFolder(const fs::path& folder, int number)
      : path_((folder / "tasks" / fmt::format("{}.XXXXXX", number)).string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      throw InputError(fmt::format("output folder {}: {}", folder.string(), strerror(errno)));
    }
  }
  ~TaskFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TaskFolder(const TaskFolder&) = delete;
  TaskFolder& operator=(const TaskFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
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
    throw InputError(fmt::format("{}: not a chunk file of a sweep", file.string()));
  }
}

void Move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw InputError(fmt::format("{}: {}", to.string(), error.message()));
}

/// Moves a row and its image to the sweep, unless the process failed and another copy of the task has flown the flight.
void PublishRow(const RowFolder& from, const RowFolder& to, const FlightRow& row) {
  const std::optional<FlightRow> existing = ReadRowOrSetAside(to.RowFile(row.id));
  if (existing && existing->process == ProcessEnd::kFlown && row.process != ProcessEnd::kFlown) return;
  if (fs::exists(from.ImageFile(row.id))) Move(from.ImageFile(row.id), to.ImageFile(row.id));
  Move(from.RowFile(row.id), to.RowFile(row.id));
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
    throw InputError(fmt::format("{}: planned by another build of the program", file.string()));
  }
  const TaskFolder task_folder(folder, number);
  const RowFolder unfinished(task_folder.path()), rows(folder);
  auto at = chunk.flights.begin();
  const auto next = [&]() -> const FlightTask* {
    while (at != chunk.flights.end() && rows.Find(at->id)) ++at;
    return at == chunk.flights.end() ? nullptr : &*at++;
  };
  const ProcessPoolOptions pool_options{
      .jobs = jobs, .fly = [&](const FlightTask& task) { FlyRow(task.scenario_yaml, task.id, unfinished); }};
  const auto publish = [&](const FlightRow& row) {
    PublishRow(unfinished, rows, row);
    on_row(row);
  };
  FlyTasks(unfinished, pool_options, next, publish, stop_requested);
  return at == chunk.flights.end();
}

}  // namespace touchdown::sweeper
