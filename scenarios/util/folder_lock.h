#pragma once

#include <filesystem>

namespace touchdown::util {

/// Creates the folder of a sweep. Throws InputError when it cannot be created or contains something else.
void ClaimFolder(const std::filesystem::path& folder);

/// Exclusive lock of a folder for the lifetime of the object. The lock also ends with the program, however that ends.
class FolderLock {
 public:
  /// Throws InputError when another program holds the lock, or the lock cannot be created.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

}  // namespace touchdown::util
