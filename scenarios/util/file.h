#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace touchdown::util {

/// Content of a file, byte for byte. Throws InputError, "PATH: cannot be read: CAUSE", when it cannot be read.
std::string ReadTextFile(const std::filesystem::path& file);

/// Same as above; nullopt when the file does not exist.
std::optional<std::string> ReadTextFileIfPresent(const std::filesystem::path& file);

}  // namespace touchdown::util
