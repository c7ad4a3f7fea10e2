#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown sweep-task`: what the tasks of a sweep on Slurm run.
void AddSweepTask(CLI::App& app, Run& run);

}  // namespace touchdown::cli
