// The program apart from its commands: help, version, bad usage and unwritable output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/program_fixture.h"

namespace touchdown::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using tests::ProgramRun;

class Program : public tests::ProgramFixture {};

TEST_F(Program, PrintsItsVersionAndItsHelp) {
  const ProgramRun version = Run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, HasSubstr("0."));
  const ProgramRun help = Run({"fly", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("--set"), HasSubstr("--seed"), HasSubstr("--estimator"), HasSubstr("--video"),
                              HasSubstr("--out")));
}

TEST_F(Program, ExitsWithTwoOnBadUsage) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{},
                                             {"flie"},
                                             {"fly"},
                                             {"fly", "a.yaml", "--sed", "1"},
                                             {"fly", "a.yaml", "--estimator"},
                                             {"fly", "a.yaml", "--video", "maybe"},
                                             {"fly", "a.yaml", "b.yaml"}}) {
    EXPECT_THAT(ErrorOf(arguments), StartsWith("error: "));
  }
  EXPECT_THAT(Names(), IsEmpty());
}

TEST_F(Program, ExitsWithThreeWhenItsOutputCannotBeWritten) {
  folder_.Put("short.yaml", kTakeoffAndLanding + "time_limit_s: 0.01\n");
  folder_.Put("sweep.yaml", "base: short.yaml\nseeds: {count: 1}\n");
  for (const std::string command : {"fly short.yaml --out result", "sweep sweep.yaml --out rows --json"}) {
    const ProgramRun run = tests::RunProgram(
        "/bin/sh", {"-c", "exec \"$0\" " + command + " > /dev/full", TOUCHDOWN_PROGRAM}, folder_.path());
    EXPECT_EQ(run.status, 3) << command;
    EXPECT_EQ(run.err, "error: internal error: cannot write to the standard output\n");
  }
}

}  // namespace
}  // namespace touchdown::cli
