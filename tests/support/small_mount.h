#pragma once

#include <gtest/gtest.h>
#include <sys/mount.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace touchdown::tests {

/// File system of at most 64 MiB mounted on a directory.
class SmallMount {
 public:
  explicit SmallMount(std::filesystem::path directory) : directory_(std::move(directory)) {
    is_mounted_ = mount("none", directory_.c_str(), "tmpfs", 0, "size=64m") == 0;
  }
  ~SmallMount() {
    if (is_mounted_) umount(directory_.c_str());
  }
  SmallMount(const SmallMount&) = delete;
  SmallMount& operator=(const SmallMount&) = delete;

  bool is_mounted() const { return is_mounted_; }
  void Fill() const { Remount(MS_REMOUNT, "size=" + std::to_string(UsedKilobytes() + 16) + "k"); }
  /// Reverts Fill and MakeReadOnly.
  void FreeSpace() const { Remount(MS_REMOUNT, "size=64m"); }
  void MakeReadOnly() const { Remount(MS_REMOUNT | MS_RDONLY, ""); }

 private:
  void Remount(unsigned long flags, const std::string& options) const {
    ASSERT_EQ(mount("none", directory_.c_str(), "tmpfs", flags, options.c_str()), 0);
  }
  std::uintmax_t UsedKilobytes() const {
    const std::filesystem::space_info space = std::filesystem::space(directory_);
    return (space.capacity - space.free) / 1024;
  }

  std::filesystem::path directory_;
  bool is_mounted_ = false;
};

}  // namespace touchdown::tests
