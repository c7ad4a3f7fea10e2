#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown paper --out DIR`: measures everything that the paper reports.
AddCommand AddPaper;

}  // namespace touchdown::cli
