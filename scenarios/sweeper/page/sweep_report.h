#pragma once

#include <filesystem>
#include <string>

#include "scenarios/sweeper/analysis/sweep_summary.h"

namespace touchdown::sweeper {

/// Signature of a sweep's page.
inline constexpr const char* kSweepPageSignature = "<!-- touchdown.sweep -->";

/// Page of a sweep with its summary, written to its folder as report.html; it links the images beside it.
/// `folder` appears verbatim in the commands that repeat a flight. Throws as Draw does.
std::string SweepPage(const SweepOutcome& sweep, const SweepSummary& summary, const std::filesystem::path& folder);

}  // namespace touchdown::sweeper
