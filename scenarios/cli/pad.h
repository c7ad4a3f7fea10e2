#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown pad --out FILE.pdf|FILE.svg [--pad PAD.yaml]`: the landing pad to print, and its description beside it.
AddCommand AddPad;

}  // namespace touchdown::cli
