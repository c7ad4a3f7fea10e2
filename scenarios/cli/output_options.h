#pragma once

#include <CLI/CLI.hpp>

namespace touchdown::cli {

/// What a long-running command prints, apart from errors.
struct OutputOptions {
  bool quiet = false;  ///< Prints neither progress nor a readable result.
  bool json = false;   ///< Prints the result as JSON on stdout, instead of as readable text.

  bool ForPeople() const { return !quiet && !json; }
};

/// Adds --quiet and --json.
inline void AddOutputOptions(CLI::App& command, OutputOptions& output) {
  command.add_flag("--quiet", output.quiet, "Print nothing but errors");
  command.add_flag("--json", output.json, "Print the result as JSON");
}

}  // namespace touchdown::cli
