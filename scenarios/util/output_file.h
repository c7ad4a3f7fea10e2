#pragma once

#include <filesystem>
#include <string_view>

namespace touchdown::util {

/// Throws InputError when WriteOutputFile would refuse the path.
void CheckOutputFile(const std::filesystem::path& place, std::string_view mark);

/// Writes a file atomically, also with respect to power loss, and creates its parent folders. No file of a user is
/// lost: an existing file is replaced only when it contains `mark`, the signature that `content` contains too. Throws
/// InputError for any other existing file, or when the file cannot be written.
void WriteOutputFile(const std::filesystem::path& place, std::string_view content, std::string_view mark);

}  // namespace touchdown::util
