#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown score --poses FILE --truth DIR`: anyone's poses of a flight against its truth.
AddCommand AddScore;

}  // namespace touchdown::cli
