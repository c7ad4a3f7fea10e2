#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::tests {

/// Runs the program in a temporary directory.
class ProgramFixture : public ::testing::Test {
 protected:
  ProgramRun Run(const std::vector<std::string>& arguments, const Interruption& interruption = {}) const {
    return RunProgram(TOUCHDOWN_PROGRAM, arguments, folder_.path(), interruption);
  }
  /// Expects that the program rejects the arguments: exit status 2 and one line on stderr. Returns the line.
  std::string ErrorOf(const std::vector<std::string>& arguments) const {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    return run.err;
  }
  /// Names of the entries of the directory.
  std::set<std::string> Names() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  static inline const std::string kTakeoffAndLanding = "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\n";

  const TemporaryFolder folder_;
};

}  // namespace touchdown::tests
