#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::scenarios {

/// `touchdown compare`: two sweeps against each other.
void AddCompare(CLI::App& app, Run& run);

}  // namespace touchdown::scenarios
