#include "scenarios/runner/expected_duration.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace touchdown::runner {
namespace {

double Expected(const char* name) {
  return ExpectedDuration_s(LoadScenario(std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" /
                                         (std::string(name) + ".yaml")));
}

/// The flights last 14.6, 6.2 and at least 66 s.
TEST(ExpectedDuration, IsCloseToFlightDurations) {
  EXPECT_NEAR(Expected("takeoff_hover_land"), 14.6, 3.0);
  EXPECT_NEAR(Expected("landing"), 6.2, 1.5);
  EXPECT_NEAR(Expected("disturbed_hover"), 66.0, 10.0);
}

TEST(ExpectedDuration, DoesNotExceedTimeLimit) {
  const Scenario scenario =
      ParseScenario("time_limit_s: 5\nscript: [{do: takeoff, height_m: 1}, {do: hover, duration_s: 60}]\n", "f", "");
  EXPECT_EQ(ExpectedDuration_s(scenario), 5.0);
}

}  // namespace
}  // namespace touchdown::runner
