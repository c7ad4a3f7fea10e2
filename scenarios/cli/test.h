#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown test`: every scenario of a folder as a flight test.
void AddTest(CLI::App& app, Run& run);

}  // namespace touchdown::cli
