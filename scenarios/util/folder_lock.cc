#include "scenarios/util/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <string.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "models/error.h"

namespace touchdown::util {

namespace fs = std::filesystem;

void ClaimFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
  if (fs::exists(folder / "sweep.db", error)) return;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().filename() != ".lock") {
      throw InputError(fmt::format("output folder {}: is not empty and contains no sweep", folder.string()));
    }
  }
  if (error) throw InputError(fmt::format("output folder {}: {}", folder.string(), error.message()));
}

FolderLock::FolderLock(const fs::path& folder) {
  const fs::path file = folder / ".lock";
  fd_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd_ < 0) throw InputError(fmt::format("output folder {}: {}", folder.string(), strerror(errno)));
  // A forked process does not inherit an fcntl lock.
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(fd_, F_SETLK, &whole) == 0) return;
  const bool is_locked = errno == EACCES || errno == EAGAIN;
  const std::string why =
      is_locked ? "is in use by another sweep" : std::string("cannot be locked: ") + strerror(errno);
  close(fd_);
  throw InputError(fmt::format("output folder {}: {}", folder.string(), why));
}

FolderLock::~FolderLock() { close(fd_); }

}  // namespace touchdown::util
