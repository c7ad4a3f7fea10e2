#pragma once

#include <filesystem>
#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Signature of a sweep page; see WriteOutputFile.
inline constexpr const char* kSweepPageSignature = "<!-- touchdown.sweep -->";

/// HTML page of a sweep. It is meant for report.html in the output directory `folder`, because it links the images
/// there by relative paths. `folder` appears verbatim in the commands that repeat a flight. Throws as Draw does.
std::string SweepPage(const SweepOutcome& sweep, const SweepSummary& summary, const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
