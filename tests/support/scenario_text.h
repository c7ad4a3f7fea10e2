#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::tests {

/// A scenario that can be flown, and what is added to it.
inline std::string With(const std::string& lines) {
  return "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\n" + lines;
}

/// As --set gives them.
inline std::vector<runner::Override> Overrides(const std::vector<std::string>& set) { return {set.begin(), set.end()}; }

/// Reads it as the file f.yaml at the project's root.
inline runner::Scenario Parse(const std::string& text, const std::vector<std::string>& set = {}) {
  return runner::ParseScenario(text, "f.yaml", TOUCHDOWN_SOURCE_DIR, Overrides(set));
}

/// What is said of a text that is wrong.
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
