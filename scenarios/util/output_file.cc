#include "scenarios/util/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "models/error.h"
#include "scenarios/util/file.h"

namespace touchdown::util {
namespace {

namespace fs = std::filesystem;

InputError UnusableFile(const fs::path& place, std::string_view why) {
  return InputError(fmt::format("output file {}: {}", place.string(), why));
}

bool ContainsSignature(const fs::path& place, std::string_view signature) {
  const std::optional<std::string> content = ReadTextFileIfPresent(place);
  return content && content->find(signature) != std::string::npos;
}

/// Flushes the content of a file, or the entries of a folder, to the disk, so that it survives a power loss.
void Sync(const fs::path& place) {
  const int fd = open(place.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return;
  fsync(fd);  // Failures are ignored, because some file systems do not support fsync.
  close(fd);
}

}  // namespace

void CheckOutputFile(const fs::path& place, std::string_view signature) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (!place.has_filename()) throw UnusableFile(place, "is not a file name");
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) throw UnusableFile(place, "exists and is not a regular file");
  if (!ContainsSignature(place, signature))
    throw UnusableFile(place, "already exists and is not an earlier output; nothing was written");
}

void WriteOutputFile(const fs::path& place, std::string_view content, std::string_view signature) {
  if (content.find(signature) == std::string_view::npos)
    throw std::logic_error("the content must contain the signature");
  CheckOutputFile(place, signature);
  std::error_code error;
  if (place.has_parent_path()) fs::create_directories(place.parent_path(), error);
  if (error) throw UnusableFile(place, error.message());
  const fs::path temporary = place.parent_path() / fmt::format(".{}.partial-{}", place.filename().string(), getpid());
  std::ofstream file(temporary, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (file) {
    Sync(temporary);
    fs::rename(temporary, place, error);
    Sync(place.has_parent_path() ? place.parent_path() : ".");
  }
  if (!file || error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw UnusableFile(place, "cannot be written");
  }
}

}  // namespace touchdown::util
