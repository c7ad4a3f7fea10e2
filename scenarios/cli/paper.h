#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::scenarios {

/// `touchdown paper --out DIR`: measures everything that the paper reports.
AddCommand AddPaper;

}  // namespace touchdown::scenarios
