#include "scenarios/sweep/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <string.h>
#include <unistd.h>

#include <cerrno>

#include "models/error.h"

namespace touchdown::scenarios {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / ".lock";
  fd_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd_ < 0) throw InputError(fmt::format("output folder {}: {}", folder.string(), strerror(errno)));
  // Of all kinds of locks the one that a forked process does not inherit.
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(fd_, F_SETLK, &whole) == 0) return;
  close(fd_);
  throw InputError(fmt::format("output folder {}: another sweep works there", folder.string()));
}

FolderLock::~FolderLock() { close(fd_); }

}  // namespace touchdown::scenarios
