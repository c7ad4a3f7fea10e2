#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchdown::util {

/// What another program did.
struct ToolRun {
  bool succeeded = false;
  std::string out = {};
  std::string err = {};
};

/// Runs a program of the PATH, the first of the arguments, to its end. nullopt when there is none of its name.
std::optional<ToolRun> RunTool(std::vector<std::string> arguments);

}  // namespace touchdown::util
