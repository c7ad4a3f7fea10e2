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

bool Holds(const fs::path& place, std::string_view mark) {
  const std::optional<std::string> content = ReadTextFileIfPresent(place);
  return content && content->find(mark) != std::string::npos;
}

/// Brings a file's content, or a folder's names, onto the disk, where the machine's sudden end does not undo it.
void Sync(const fs::path& place) {
  const int fd = open(place.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return;
  fsync(fd);  // Some file systems know no such thing; then this is all that can be done.
  close(fd);
}

}  // namespace

void CheckOutputFile(const fs::path& place, std::string_view mark) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (!place.has_filename()) throw UnusableFile(place, "is no place for a file");
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) throw UnusableFile(place, "is something else than a file");
  if (!Holds(place, mark)) throw UnusableFile(place, "is there already, and something else; nothing was written");
}

void WriteOutputFile(const fs::path& place, std::string_view content, std::string_view mark) {
  if (content.find(mark) == std::string_view::npos) throw std::logic_error("a file must hold its mark");
  CheckOutputFile(place, mark);
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
