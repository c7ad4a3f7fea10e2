#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::tests {

/// Text of a valid scenario plus additional lines.
inline std::string With(const std::string& lines) {
  return "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\n" + lines;
}

/// Overrides from arguments of --set.
inline std::vector<runner::Override> Overrides(const std::vector<std::string>& set) { return {set.begin(), set.end()}; }

/// Parses a text as the file f.yaml in the root of the project.
inline runner::Scenario Parse(const std::string& text, const std::vector<std::string>& set = {}) {
  return runner::ParseScenario(text, "f.yaml", TOUCHDOWN_SOURCE_DIR, Overrides(set));
}

/// Error message of Parse for an invalid text.
inline std::string ErrorOf(const std::string& text, const std::vector<std::string>& set = {}) {
  try {
    Parse(text, set);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError for\n" << text;
  return "";
}

}  // namespace touchdown::tests
