#pragma once

#include <optional>
#include <string>

#include "scenarios/cli/talk.h"

namespace touchdown::scenarios {

/// Where a sweep's results go: the page lies in its folder.
struct SweepFiles {
  std::string folder = {};
  std::optional<std::string> csv = {};
};

/// Throws InputError when a file is there already that this program has not made.
void CheckSweepFiles(const SweepFiles& files);

/// Writes the page and the CSV of what is flown, and prints the summary. Returns whether the criteria are kept. A page
/// that cannot be drawn is a warning: it does not make a sweep of hours fail. Throws InputError when a file cannot be
/// written.
bool TellOutcome(const SweepFiles& files, const Talk& talk);

}  // namespace touchdown::scenarios
