#pragma once

#include <string>

namespace touchdown::util {

/// SHA-256 of the executable of this process. It identifies the build that produced a result.
const std::string& ProgramDigest();

}  // namespace touchdown::util
