#pragma once

#include <filesystem>
#include <vector>

namespace touchdown::sweeper {

/// Takes the rows that programs left in `folder` into its store; then the plans, rows and pictures of the parts of the
/// same sweep in the folders `from`, which are left as they are. With parts, `folder` is made when it is not there.
/// Throws InputError, before anything is written, when one is no sweep's, or another sweep's or build's.
void Collect(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& from);

}  // namespace touchdown::sweeper
