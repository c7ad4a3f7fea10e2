#pragma once

#include <string>

namespace touchdown::util {

/// SHA-256 of the running program's file: what another build did is told apart by it.
const std::string& ProgramDigest();

}  // namespace touchdown::util
