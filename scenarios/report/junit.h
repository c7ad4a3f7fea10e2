#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/runner/fly.h"

namespace touchdown::report {

/// Signature that identifies a JUnit file written by Touchdown.
inline constexpr char kJunitSignature[] = "<testsuites name=\"touchdown\"";

/// JUnit test suite of one flight, with one test case per check.
struct JunitSuite {
  std::string name;
  double time_s = 0.0;  ///< Simulated duration of the flight.
  std::vector<runner::Check> checks;
  std::optional<std::string> error;  ///< Error of the simulation. When set, every test case is an error.
};

/// Writes suites as JUnit XML for CI servers. A failed check is a failure of its test case. When a suite has an error,
/// every test case of it is an error with that message.
std::string JunitXml(const std::vector<JunitSuite>& suites);

/// Builds the suite of a flight. `reason` becomes its error when the verdict is kError.
JunitSuite SuiteOf(const runner::Scenario& scenario, runner::Verdict verdict, const std::string& reason,
                   const runner::Metrics& metrics, const std::vector<runner::Check>& checks);

}  // namespace touchdown::report
