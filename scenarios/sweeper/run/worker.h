#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace touchdown::sweeper {

/// How a worker ended.
struct WorkerEnd {
  int exit_status = 0;           ///< When it was not ended by a signal.
  int signal = 0;                ///< 0: none.
  std::string stderr_tail = {};  ///< The last lines that it wrote to stderr.
};

/// Work in a process of its own, forked from this one: whatever becomes of it, this one goes on. It is in a process
/// group of its own, so that Ctrl-C does not reach it, and ends with its parent. What forks must have no other threads.
class Worker {
 public:
  /// Its exit status is what `work` returns. `memory_mb` limits its address space; 0: no limit. Throws
  /// std::system_error when the system has no process left.
  Worker(const std::function<int()>& work, int memory_mb);
  /// Ends it if it still runs.
  ~Worker();
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&&) = delete;

  /// nullopt while it runs.
  std::optional<WorkerEnd> Poll();
  void Kill();

 private:
  pid_t pid_ = -1;
  int stderr_fd_ = -1;
};

}  // namespace touchdown::sweeper
