#pragma once

#include <filesystem>
#include <string_view>

namespace touchdown::util {

/// Throws InputError when WriteOutputFile would refuse the place.
void CheckOutputFile(const std::filesystem::path& place, std::string_view mark);

/// Writes a file that is there whole or not at all, also after the machine's sudden end, and the folders above it.
/// Nothing that a user made is lost: what is there already is replaced only when it holds `mark`, as `content` does,
/// by which an earlier file of the same kind is recognized. Throws InputError when it is something else, or cannot be
/// written.
void WriteOutputFile(const std::filesystem::path& place, std::string_view content, std::string_view mark);

}  // namespace touchdown::util
