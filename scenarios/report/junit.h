#pragma once

#include <string>

#include "scenarios/flight/fly.h"

namespace touchdown::scenarios {

/// What a JUnit file of Touchdown's, and none of another program's, holds.
inline constexpr char kJunitMark[] = "<testsuites name=\"touchdown\"";

/// A flight's checks as JUnit XML, as CI servers read it: a test suite with a test case for each check, its time the
/// simulated one. A flight whose simulation went wrong is an error of every case.
std::string JunitXml(const Scenario& scenario, const FlightResult& result);

}  // namespace touchdown::scenarios
