#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace touchdown::util {

/// Content of a file. Throws InputError "PATH: cannot be read: CAUSE" on failure.
std::string ReadTextFile(const std::filesystem::path& file);

/// Content of a file; nullopt if the file does not exist. Throws InputError on other failures.
std::optional<std::string> ReadTextFileIfPresent(const std::filesystem::path& file);

}  // namespace touchdown::util
