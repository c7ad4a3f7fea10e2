#pragma once

#include <filesystem>
#include <vector>

namespace touchdown::sweeper {

/// Moves the row files in `folder` into its store; then copies the plans, rows and images of the parts of the same
/// sweep in the folders `from`, which do not change. With parts, `folder` is created when it does not exist. Throws
/// InputError, before anything is written, for a folder without a sweep, or of another sweep or build.
void Collect(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& from);

}  // namespace touchdown::sweeper
