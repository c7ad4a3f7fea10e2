#include "scenarios/util/process.h"

#include <gtest/gtest.h>

namespace touchdown::util {
namespace {

TEST(RunProcess, ReturnsOutputAndSuccess) {
  const auto good = RunProcess({"sh", "-c", "echo out; echo err >&2"});
  EXPECT_TRUE(good.value().succeeded);
  EXPECT_EQ(good->out, "out\n");
  EXPECT_EQ(good->err, "err\n");
  EXPECT_FALSE(RunProcess({"sh", "-c", "exit 3"}).value().succeeded);
  EXPECT_FALSE(RunProcess({"sh", "-c", "kill -9 $$"}).value().succeeded);
}

TEST(RunProcess, ReturnsNulloptForMissingProgram) { EXPECT_EQ(RunProcess({"no_such_program_at_all"}), std::nullopt); }

}  // namespace
}  // namespace touchdown::util
