#pragma once

#include <filesystem>
#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// What a sweep's page is known again by.
inline constexpr const char* kSweepPageSignature = "<!-- touchdown.sweep -->";

/// The page of a sweep and its summary, which lies in its folder as report.html and shows the pictures beside it.
/// `folder` appears verbatim in the commands that repeat a flight. Throws as Draw does.
std::string SweepPage(const SweepOutcome& sweep, const SweepSummary& summary, const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
