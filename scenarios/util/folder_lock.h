#pragma once

#include <filesystem>

namespace touchdown::util {

/// Creates the output folder of a sweep. Throws InputError if it cannot be created or contains files but no sweep.
void ClaimFolder(const std::filesystem::path& folder);

/// Exclusive lock of a folder for the lifetime of the object. The operating system releases it
/// when the program ends for any reason.
class FolderLock {
 public:
  /// Throws InputError if another program holds the lock or the lock cannot be created.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

}  // namespace touchdown::util
