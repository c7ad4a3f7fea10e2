#include "scenarios/sweeper/run/process_pool.h"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>

#include <chrono>
#include <list>
#include <new>
#include <opencv2/core.hpp>
#include <optional>
#include <thread>

#include "models/error.h"
#include "scenarios/sweeper/run/worker.h"
#include "scenarios/util/platform.h"
#include "scenarios/util/program_digest.h"
#include "scenarios/util/stopwatch.h"
#include "scenarios/util/version.h"

namespace touchdown::sweeper {
namespace {

constexpr int kUnusableFolderStatus = 2;
constexpr int kOutOfMemoryStatus = 5;

struct Flying {
  const FlightTask* task;
  Worker worker;
  util::Stopwatch since_start = {};
  bool is_hung = false;
};

/// Row for a process that wrote none.
FlightRow RowWithoutFlight(const Flying& flying, const WorkerEnd& end) {
  FlightRow row{.id = flying.task->id,
                .program = util::ProgramDigest(),
                .version = std::string(util::Version()),
                .host = util::HostName(),
                .failed_check = "outcome",
                .wall_s = flying.since_start.seconds(),
                .stderr_tail = end.stderr_tail,
                .scenario = flying.task->scenario_yaml};
  if (flying.is_hung) {
    row.process = ProcessEnd::kHung;
    row.reason = fmt::format("not done after {:g} s", flying.task->limit_s);
  } else if (end.signal == SIGKILL) {
    row.process = ProcessEnd::kOutOfMemory;
    row.reason = "killed by the system, as it does when memory runs out";
  } else if (end.exit_status == kOutOfMemoryStatus) {
    row.process = ProcessEnd::kOutOfMemory;
    row.reason = "needs more memory than its limit";
  } else if (end.signal != 0) {
    row.process = ProcessEnd::kCrashed;
    row.reason = fmt::format("the program crashed: {}", strsignal(end.signal));
  } else {
    row.process = ProcessEnd::kCrashed;
    row.reason = fmt::format("the program ended with status {}", end.exit_status);
  }
  return row;
}

std::string LastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// Main function of a worker; returns its exit status.
int FlyAndExplain(const ProcessPoolOptions& options, const FlightTask& task) {
  try {
    options.fly(task);
    return 0;
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kUnusableFolderStatus;
  } catch (const std::bad_alloc&) {
    return kOutOfMemoryStatus;
  } catch (const cv::Exception& error) {
    if (error.code != cv::Error::StsNoMem) throw;
    return kOutOfMemoryStatus;
  }
}

}  // namespace

void FlyTasks(const RowFolder& folder, const ProcessPoolOptions& options, const NextTask& next, const OnRow& on_row,
              const util::StopRequested& stop_requested) {
  constexpr std::chrono::milliseconds kLookEvery(5);
  std::list<Flying> flying;
  const auto start_more = [&] {
    while (static_cast<int>(flying.size()) < options.jobs && !(stop_requested && stop_requested())) {
      const FlightTask* task = next();
      if (task == nullptr) return;
      flying.push_back({task, Worker([&] { return FlyAndExplain(options, *task); }, task->memory_mb)});
    }
  };
  const auto finish = [&](const Flying& done, const WorkerEnd& end) {
    std::optional<FlightRow> row = folder.Find(done.task->id);
    if (!row && end.exit_status == kUnusableFolderStatus) {
      throw InputError(LastLine(end.stderr_tail));
    }
    const bool is_stopped = stop_requested && stop_requested();
    if (!row && is_stopped && !done.is_hung && end.signal == SIGKILL) return;  // It was ended with all the others.
    if (!row) {
      row = RowWithoutFlight(done, end);
      folder.Leave(*row);
    } else if (row->stderr_tail != end.stderr_tail) {
      row->stderr_tail = end.stderr_tail;
      folder.Leave(*row);
    }
    on_row(*row);
  };
  for (start_more(); !flying.empty(); start_more()) {
    std::this_thread::sleep_for(kLookEvery);
    for (auto each = flying.begin(); each != flying.end();) {
      if (!each->is_hung && each->since_start.seconds() > each->task->limit_s) {
        each->is_hung = true;
        each->worker.Kill();
      }
      if (const auto end = each->worker.Poll()) {
        const Flying done = std::move(*each);
        each = flying.erase(each);
        finish(done, *end);
      } else {
        ++each;
      }
    }
  }
}

}  // namespace touchdown::sweeper
