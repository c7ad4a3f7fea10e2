#pragma once

#include <filesystem>

namespace touchdown::util {

/// Makes a sweep's folder. Throws InputError when it cannot be made, or holds something else than a sweep.
void ClaimFolder(const std::filesystem::path& folder);

/// That nobody else works in a folder, while it lives. It ends with the program, however that ends.
class FolderLock {
 public:
  /// Throws InputError when another program works there, or the lock cannot be made.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

}  // namespace touchdown::util
