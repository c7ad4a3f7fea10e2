#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown fly SCENARIO [--set key=value]... [--seed N] [--estimator NAME] [--video on|off] [--out DIR]`: one
/// flight, its verdict and its files.
AddCommand AddFly;

}  // namespace touchdown::cli
