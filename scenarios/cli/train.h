#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown train --out DIR [--letter h|rectangle] [--seed N]`: the classifier's training set, its training, its
/// confusion matrix on scenes never trained on, and its C code.
AddCommand AddTrain;

}  // namespace touchdown::cli
