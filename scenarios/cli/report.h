#pragma once

#include "scenarios/cli/command.h"

namespace touchdown::cli {

/// `touchdown report DIR`: rebuilds the page of a flight or a sweep from its folder's files.
AddCommand AddReport;

}  // namespace touchdown::cli
