#include "scenarios/report/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

namespace touchdown::scenarios {
namespace {

void PutCounts(pugi::xml_node node, const FlightResult& result) {
  const auto failed = std::count_if(result.checks.begin(), result.checks.end(), [](const Check& c) { return !c.pass; });
  const bool is_error = result.verdict == Verdict::kError;
  const auto tests = static_cast<long long>(result.checks.size());
  node.append_attribute("tests") = tests;
  node.append_attribute("failures") = is_error ? 0LL : static_cast<long long>(failed);
  node.append_attribute("errors") = is_error ? tests : 0LL;
  node.append_attribute("time") = fmt::format("{}", result.metrics.at("flight.sim_time_s")).c_str();
}

/// "is 0.12 m, must be <= 0.06".
std::string Explain(const Check& check) {
  const std::string value =
      check.value ? fmt::format("{} {}", *check.value, check.unit) : (check.text.empty() ? "not there" : check.text);
  return fmt::format("is {}, must be {}", value, check.limit);
}

void PutCase(pugi::xml_node suite, const std::string& suite_name, const Check& check, const FlightResult& result) {
  pugi::xml_node test = suite.append_child("testcase");
  test.append_attribute("classname") = suite_name.c_str();
  test.append_attribute("name") = check.name.c_str();
  if (result.verdict == Verdict::kError) {
    test.append_child("error").append_attribute("message") = result.reason.c_str();
  } else if (!check.pass) {
    test.append_child("failure").append_attribute("message") = Explain(check).c_str();
  }
}

}  // namespace

std::string JunitXml(const Scenario& scenario, const FlightResult& result) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  suites.append_attribute("name") = "touchdown";
  PutCounts(suites, result);
  pugi::xml_node suite = suites.append_child("testsuite");
  const std::string name = fmt::format("{}.seed{}", scenario.name, scenario.seed);
  suite.append_attribute("name") = name.c_str();
  PutCounts(suite, result);
  for (const Check& check : result.checks) PutCase(suite, name, check, result);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace touchdown::scenarios
