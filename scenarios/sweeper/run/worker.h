#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// End of a worker process.
struct WorkerEnd {
  int exit_status = 0;           ///< Valid if no signal ended it.
  int signal = 0;                ///< 0: none.
  std::string stderr_tail = {};  ///< The last lines that it wrote to stderr.
};

/// A function that runs in a forked process; a crash of it does not affect the parent. The process has its own process
/// group, so that Ctrl-C does not reach it, and ends with its parent. The parent must have no other threads.
class Worker {
 public:
  /// Starts the process; its exit status is the result of `work`. `memory_mb` limits its address space; 0: no limit.
  /// Throws std::system_error when no process can be created.
  Worker(const std::function<int()>& work, int memory_mb);
  /// Kills the process if it still runs.
  ~Worker();
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&&) = delete;

  /// End of the process; nullopt while it runs.
  std::optional<WorkerEnd> Poll();
  void Kill();

 private:
  pid_t pid_ = -1;
  int stderr_fd_ = -1;
};

}  // namespace touchdown::sweeper
