#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "models/error.h"

namespace touchdown::util {

/// Temporary folder, removed by the destructor. Throws InputError when it cannot be created.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "touchdown.XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw InputError("a temporary folder cannot be created");
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace touchdown::util
