#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown status`: how far a sweep is.
void AddStatus(CLI::App& app, Run& run);

}  // namespace touchdown::cli
