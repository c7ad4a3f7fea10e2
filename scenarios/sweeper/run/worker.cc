#include "scenarios/sweeper/run/worker.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace touchdown::sweeper {
namespace {

constexpr int kFailedStatus = 3;

#ifdef __SANITIZE_ADDRESS__
constexpr bool kMemoryCanBeLimited = false;  // The sanitizer needs far more address space.
#else
constexpr bool kMemoryCanBeLimited = true;
#endif

/// Reads the last 4000 bytes of a file.
std::string ReadTail(int fd) {
  constexpr off_t kMost = 4000;
  const off_t size = lseek(fd, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - kMost);
  std::string text(static_cast<std::size_t>(size - from), '\0');
  const ssize_t count = pread(fd, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  return text;
}

/// Main function of the forked process.
[[noreturn]] void WorkerMain(const std::function<int()>& work, int stderr_fd, rlim_t memory, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_NAME, "touchdown-fly");
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kFailedStatus);  // The parent ended before PR_SET_PDEATHSIG was set.
  dup2(open("/dev/null", O_RDWR), STDIN_FILENO);
  dup2(STDIN_FILENO, STDOUT_FILENO);
  dup2(stderr_fd, STDERR_FILENO);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (memory > 0 && kMemoryCanBeLimited) {
    const rlimit limit{memory, memory};
    setrlimit(RLIMIT_AS, &limit);
  }
  int status = kFailedStatus;
  try {
    status = work();
  } catch (const std::exception& error) {
    fprintf(stderr, "internal error: %s\n", error.what());
  }
  fflush(stderr);
  _exit(status);  // Skips the destructors and buffers inherited from the parent.
}

}  // namespace

Worker::Worker(const std::function<int()>& work, int memory_mb) {
  stderr_fd_ = memfd_create("stderr", MFD_CLOEXEC);
  const rlim_t memory = static_cast<rlim_t>(memory_mb) << 20;
  const pid_t parent = getpid();
  fflush(nullptr);
  pid_ = stderr_fd_ < 0 ? -1 : fork();
  if (pid_ == 0) WorkerMain(work, stderr_fd_, memory, parent);
  if (pid_ > 0) return;
  const int error = errno;
  if (stderr_fd_ >= 0) close(stderr_fd_);
  throw std::system_error(error, std::generic_category(), "cannot start a process");
}

Worker::Worker(Worker&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), stderr_fd_(std::exchange(other.stderr_fd_, -1)) {}

Worker::~Worker() {
  if (pid_ > 0) {
    Kill();
    waitpid(pid_, nullptr, 0);
  }
  if (stderr_fd_ >= 0) close(stderr_fd_);
}

std::optional<WorkerEnd> Worker::Poll() {
  int status = 0;
  const pid_t ended = waitpid(pid_, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
  pid_ = -1;
  WorkerEnd end{.stderr_tail = ReadTail(stderr_fd_)};
  if (WIFSIGNALED(status)) {
    end.signal = WTERMSIG(status);
  } else {
    end.exit_status = WEXITSTATUS(status);
  }
  return end;
}

void Worker::Kill() { kill(pid_, SIGKILL); }

}  // namespace touchdown::sweeper
