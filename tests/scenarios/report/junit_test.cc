#include "scenarios/report/junit.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

namespace touchdown::report {
namespace {

runner::Scenario NamedScenario() {
  runner::Scenario scenario;
  scenario.name = "calm";
  scenario.seed = 7;
  return scenario;
}

runner::FlightResult Result(runner::Verdict verdict) {
  runner::FlightResult result;
  result.verdict = verdict;
  result.reason = "MuJoCo: <bad> & worse";
  result.metrics["flight.sim_time_s"] = 12.5;
  result.checks.push_back(
      {.name = "outcome", .value = {}, .text = "landed", .unit = "", .limit = "landed", .pass = true});
  result.checks.push_back(
      {.name = "flight.touchdown_tilt_deg", .value = 11.5, .text = "", .unit = "deg", .limit = "<= 10", .pass = false});
  return result;
}

std::string Xml(runner::Verdict verdict) {
  const runner::FlightResult result = Result(verdict);
  return JunitXml({SuiteOf(NamedScenario(), result.verdict, result.reason, result.metrics, result.checks)});
}

TEST(Junit, SumsCountsOfSuites) {
  const runner::FlightResult result = Result(runner::Verdict::kFail);
  const JunitSuite suite = SuiteOf(NamedScenario(), result.verdict, result.reason, result.metrics, result.checks);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(JunitXml({suite, suite}).c_str()));
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(suites.attribute("tests").as_int(), 4);
  EXPECT_EQ(suites.attribute("failures").as_int(), 2);
  EXPECT_EQ(suites.attribute("time").as_double(), 25.0);
}

TEST(Junit, WritesCasePerCheckAndCountsFailures) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(Xml(runner::Verdict::kFail).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_STREQ(suite.attribute("name").value(), "calm.seed7");
  EXPECT_EQ(suite.attribute("tests").as_int(), 2);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("errors").as_int(), 0);
  EXPECT_EQ(suite.attribute("time").as_double(), 12.5);
  const pugi::xml_node passed = suite.first_child(), failed = suite.last_child();
  EXPECT_STREQ(passed.attribute("name").value(), "outcome");
  EXPECT_FALSE(passed.first_child());
  EXPECT_STREQ(failed.child("failure").attribute("message").value(), "is 11.5 deg, must be <= 10");
}

TEST(Junit, WritesErrorInEveryCaseAfterSimulationError) {
  const std::string text = Xml(runner::Verdict::kError);
  EXPECT_NE(text.find(kJunitSignature), std::string::npos);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(suites.attribute("errors").as_int(), 2);
  EXPECT_EQ(suites.attribute("failures").as_int(), 0);
  for (const pugi::xml_node& test : suites.first_child().children()) {
    EXPECT_STREQ(test.child("error").attribute("message").value(), "MuJoCo: <bad> & worse");
  }
}

}  // namespace
}  // namespace touchdown::report
