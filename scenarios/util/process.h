#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchdown::util {

/// Result of a process that exited.
struct ProcessResult {
  bool succeeded = false;  ///< It exited with status 0.
  std::string out = {};    ///< Output on stdout.
  std::string err = {};    ///< Output on stderr.
};

/// Runs a program, found on the PATH by the first of `arguments`, and waits for its end. nullopt when the program does
/// not exist.
std::optional<ProcessResult> RunProcess(std::vector<std::string> arguments);

}  // namespace touchdown::util
