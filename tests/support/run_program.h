#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace touchdown::tests {

/// What a program did.
struct ProgramRun {
  int status = -1;  ///< Exit status; -1 when a signal ended it.
  std::string out;
  std::string err;
};

/// A signal for the program, sent once `when` is true.
struct Interruption {
  int signal = 0;
  std::function<bool()> when;
};

/// Runs a program in `folder` to its end; interrupts it when `interruption` has a signal.
ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder, const Interruption& interruption = {});

}  // namespace touchdown::tests
