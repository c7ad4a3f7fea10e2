#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace touchdown::cli {

/// What the program's exit status says.
enum ExitStatus : int {
  kPassed = 0,         ///< Done, and passed.
  kFailed = 1,         ///< Flown, but failed its criteria.
  kBadInput = 2,       ///< Bad usage, bad input or unusable output folder.
  kInternalError = 3,  ///< The simulation went wrong, or the program.
  kInterrupted = 130,  ///< Ctrl-C.
};

/// What the chosen command does once the command line is read; returns an ExitStatus. It may throw InputError
/// (kBadInput), Interrupted (kInterrupted) and anything else (kInternalError): the main function says so to the user.
using Run = std::function<int()>;

/// A command adds itself as a subcommand whose callback sets `run`. One function of this kind for each file in cli/.
using AddCommand = void(CLI::App& app, Run& run);

}  // namespace touchdown::cli
