#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown collect`: the rows of a sweep that flew elsewhere.
void AddCollect(CLI::App& app, Run& run);

}  // namespace touchdown::cli
