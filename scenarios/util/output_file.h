#pragma once

#include <filesystem>
#include <string_view>

namespace touchdown::util {

/// Throws InputError if WriteOutputFile would reject the path.
void CheckOutputFile(const std::filesystem::path& place, std::string_view signature);

/// Writes a file atomically, also with respect to power loss, and creates its parent folders. Replaces an existing
/// file only if it contains `signature`, as `content` must, so that no other file of the user is lost. Throws
/// InputError for any other existing file and for a file that cannot be written.
void WriteOutputFile(const std::filesystem::path& place, std::string_view content, std::string_view signature);

}  // namespace touchdown::util
