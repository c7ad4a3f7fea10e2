#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/runner/fly.h"

namespace touchdown::report {

/// What a JUnit file of Touchdown's, and none of another program's, holds.
inline constexpr char kJunitSignature[] = "<testsuites name=\"touchdown\"";

/// A flight and its checks.
struct JunitSuite {
  std::string name;
  double time_s = 0.0;  ///< Simulated.
  std::vector<runner::Check> checks;
  std::optional<std::string> error;  ///< What went wrong with the simulation, in place of its checks.
};

/// Flights as JUnit XML, as CI servers read it: each a test suite with a test case for each check. A flight whose
/// simulation went wrong is an error of every case.
std::string JunitXml(const std::vector<JunitSuite>& suites);

JunitSuite SuiteOf(const runner::Scenario& scenario, runner::Verdict verdict, const std::string& reason,
                   const runner::Metrics& metrics, const std::vector<runner::Check>& checks);

}  // namespace touchdown::report
