#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchdown::util {

/// Result of a process that exited.
struct ProcessResult {
  bool succeeded = false;  ///< The process exited with status 0.
  std::string out = {};    ///< Output on stdout.
  std::string err = {};    ///< Output on stderr.
};

/// Runs a program and waits for its end. The first of `arguments` is its name, which is searched on the PATH. Returns
/// nullopt if the program cannot be started.
std::optional<ProcessResult> RunProcess(std::vector<std::string> arguments);

}  // namespace touchdown::util
