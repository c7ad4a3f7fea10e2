#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown sweep`: many flights.
void AddSweep(CLI::App& app, Run& run);

}  // namespace touchdown::cli
