#include "scenarios/report/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

namespace touchdown::report {
namespace {

struct Counts {
  long long tests = 0, failures = 0, errors = 0;
  double time_s = 0.0;

  void Add(const JunitSuite& suite) {
    const auto count = static_cast<long long>(suite.checks.size());
    const auto failed =
        std::count_if(suite.checks.begin(), suite.checks.end(), [](const runner::Check& c) { return !c.pass; });
    tests += count;
    failures += suite.error ? 0 : failed;
    errors += suite.error ? count : 0;
    time_s += suite.time_s;
  }
};

void PutCounts(pugi::xml_node node, const Counts& counts) {
  node.append_attribute("tests") = counts.tests;
  node.append_attribute("failures") = counts.failures;
  node.append_attribute("errors") = counts.errors;
  node.append_attribute("time") = fmt::format("{}", counts.time_s).c_str();
}

/// Message of a failed check: "is 0.12 m, must be <= 0.06".
std::string Explain(const runner::Check& check) {
  const std::string value =
      check.value ? fmt::format("{} {}", *check.value, check.unit) : (check.text.empty() ? "missing" : check.text);
  return fmt::format("is {}, must be {}", value, check.limit);
}

void PutCase(pugi::xml_node node, const JunitSuite& suite, const runner::Check& check) {
  pugi::xml_node test = node.append_child("testcase");
  test.append_attribute("classname") = suite.name.c_str();
  test.append_attribute("name") = check.name.c_str();
  if (suite.error) {
    test.append_child("error").append_attribute("message") = suite.error->c_str();
  } else if (!check.pass) {
    test.append_child("failure").append_attribute("message") = Explain(check).c_str();
  }
}

}  // namespace

std::string JunitXml(const std::vector<JunitSuite>& suites) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("testsuites");
  root.append_attribute("name") = "touchdown";
  Counts all;
  for (const JunitSuite& suite : suites) all.Add(suite);
  PutCounts(root, all);
  for (const JunitSuite& suite : suites) {
    pugi::xml_node node = root.append_child("testsuite");
    node.append_attribute("name") = suite.name.c_str();
    Counts counts;
    counts.Add(suite);
    PutCounts(node, counts);
    for (const runner::Check& check : suite.checks) PutCase(node, suite, check);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

JunitSuite SuiteOf(const runner::Scenario& scenario, runner::Verdict verdict, const std::string& reason,
                   const runner::Metrics& metrics, const std::vector<runner::Check>& checks) {
  const auto time = metrics.find("flight.sim_time_s");
  return {.name = fmt::format("{}.seed{}", scenario.name, scenario.seed),
          .time_s = time == metrics.end() ? 0.0 : time->second,
          .checks = checks,
          .error = verdict == runner::Verdict::kError ? std::optional(reason) : std::nullopt};
}

}  // namespace touchdown::report
