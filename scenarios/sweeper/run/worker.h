#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// End of a worker process.
struct WorkerEnd {
  int exit_status = 0;           ///< Valid if the process was not ended by a signal.
  int signal = 0;                ///< Signal that ended the process; 0: none.
  std::string stderr_tail = {};  ///< The last lines that it wrote to stderr.
};

/// Runs a function in a forked process. A crash of this process does not affect the parent. The process has its own
/// process group, so that Ctrl-C does not reach it, and it ends when the parent ends. The parent must have no other
/// threads.
class Worker {
 public:
  /// Starts the process; its exit status is the result of `work`. `memory_mb` limits its address space; 0: no limit.
  /// Throws std::system_error if no process can be created.
  Worker(const std::function<int()>& work, int memory_mb);
  /// Kills the process if it is still running.
  ~Worker();
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&&) = delete;

  /// Returns the end of the process; nullopt while it runs.
  std::optional<WorkerEnd> Poll();
  /// Kills the process with SIGKILL.
  void Kill();

 private:
  pid_t pid_ = -1;
  int stderr_fd_ = -1;
};

}  // namespace touchdown::sweeper
