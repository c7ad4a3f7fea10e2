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

struct RunningTask {
  const FlightTask* task;
  Worker worker;
  util::Stopwatch since_start = {};
  bool is_hung = false;
};

/// Row of a flight whose process wrote none.
FlightRow RowOfFailedProcess(const RunningTask& running, const WorkerEnd& end) {
  FlightRow row{.id = running.task->id,
                .program = util::ProgramDigest(),
                .version = std::string(util::Version()),
                .host = util::HostName(),
                .failed_check = "outcome",
                .wall_s = running.since_start.seconds(),
                .stderr_tail = end.stderr_tail,
                .scenario = running.task->scenario_yaml};
  if (running.is_hung) {
    row.process = ProcessEnd::kHung;
    row.reason = fmt::format("exceeded the time limit of {:g} s", running.task->limit_s);
  } else if (end.signal == SIGKILL) {
    row.process = ProcessEnd::kOutOfMemory;
    row.reason = "killed by the system, probably because it ran out of memory";
  } else if (end.exit_status == kOutOfMemoryStatus) {
    row.process = ProcessEnd::kOutOfMemory;
    row.reason = "exceeded the memory limit";
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

/// Flies a task in the worker process. Returns the exit status.
int RunTask(const ProcessPoolOptions& options, const FlightTask& task) {
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
  constexpr std::chrono::milliseconds kPollInterval(5);
  std::list<RunningTask> running;
  const auto start_more = [&] {
    while (static_cast<int>(running.size()) < options.jobs && !(stop_requested && stop_requested())) {
      const FlightTask* task = next();
      if (task == nullptr) return;
      running.push_back({task, Worker([&] { return RunTask(options, *task); }, task->memory_mb)});
    }
  };
  const auto finish = [&](const RunningTask& done, const WorkerEnd& end) {
    std::optional<FlightRow> row = folder.Find(done.task->id);
    if (!row && end.exit_status == kUnusableFolderStatus) {
      throw InputError(LastLine(end.stderr_tail));
    }
    const bool is_stopped = stop_requested && stop_requested();
    if (!row && is_stopped && !done.is_hung && end.signal == SIGKILL)
      return;  // It was killed along with the other processes.
    if (!row) {
      row = RowOfFailedProcess(done, end);
      folder.Write(*row);
    } else if (row->stderr_tail != end.stderr_tail) {
      row->stderr_tail = end.stderr_tail;
      folder.Write(*row);
    }
    on_row(*row);
  };
  for (start_more(); !running.empty(); start_more()) {
    std::this_thread::sleep_for(kPollInterval);
    for (auto each = running.begin(); each != running.end();) {
      if (!each->is_hung && each->since_start.seconds() > each->task->limit_s) {
        each->is_hung = true;
        each->worker.Kill();
      }
      if (const auto end = each->worker.Poll()) {
        const RunningTask done = std::move(*each);
        each = running.erase(each);
        finish(done, *end);
      } else {
        ++each;
      }
    }
  }
}

}  // namespace touchdown::sweeper
