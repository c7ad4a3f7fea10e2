#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown compare`: two sweeps against each other.
void AddCompare(CLI::App& app, Run& run);

}  // namespace touchdown::cli
