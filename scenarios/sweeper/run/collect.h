#pragma once

#include <filesystem>
#include <vector>

namespace touchdown::sweeper {

/// Moves the row files in the output directory `folder` into its database. Then copies the plans, rows and images from
/// the directories `from`, which contain parts of the same sweep and do not change. With parts, `folder` is created if
/// it does not exist. Throws InputError, before anything is written, for a directory without a sweep, or with another
/// sweep or the sweep of another build.
void Collect(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& from);

}  // namespace touchdown::sweeper
