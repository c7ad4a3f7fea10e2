#pragma once

#include <CLI/CLI.hpp>

namespace touchdown::cli {

/// What a command that works for long says, beside its errors.
struct OutputOptions {
  bool quiet = false;  ///< Neither progress nor a result for people.
  bool json = false;   ///< The result as JSON on stdout, in place of the one for people.

  bool ForPeople() const { return !quiet && !json; }
};

/// Adds --quiet and --json.
inline void AddOutputOptions(CLI::App& command, OutputOptions& output) {
  command.add_flag("--quiet", output.quiet, "Say nothing but errors");
  command.add_flag("--json", output.json, "Print the result as JSON");
}

}  // namespace touchdown::cli
