#pragma once

#include <sys/resource.h>

#include <csignal>

namespace touchdown::tests {

/// No file of this process grows beyond a size, as on a disk that is full, until the end of the scope.
class DiskOfSize {
 public:
  explicit DiskOfSize(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~DiskOfSize() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  DiskOfSize(const DiskOfSize&) = delete;
  DiskOfSize& operator=(const DiskOfSize&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace touchdown::tests
