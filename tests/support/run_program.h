#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace touchdown::tests {

/// Exit status and output of a program.
struct ProgramRun {
  int status = -1;  ///< Exit status; -1 if a signal ended the program.
  std::string out;
  std::string err;
};

/// Signal to send to the program when `when` returns true.
struct Interruption {
  int signal = 0;
  std::function<bool()> when;
};

/// Runs a program in `folder` and waits for its end. Sends the signal of `interruption`, if any.
ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder, const Interruption& interruption = {});

}  // namespace touchdown::tests
