#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace touchdown::testing {

/// What a program did.
struct ProgramRun {
  int status = -1;  ///< Exit status; -1 when a signal ended it.
  std::string out;
  std::string err;
};

/// Runs a program in `folder` to its end. `interrupt_after_ms` >= 0 sends it SIGINT after that time.
ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder, int interrupt_after_ms = -1);

}  // namespace touchdown::testing
