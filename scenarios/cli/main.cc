#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <stdexcept>
#include <string>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/util/interrupted.h"
#include "scenarios/util/version.h"

namespace {

using touchdown::cli::AddCommand;
using touchdown::cli::ExitStatus;
using touchdown::cli::Run;

AddCommand* const kCommands[] = {touchdown::cli::AddCalibrate, touchdown::cli::AddCollect, touchdown::cli::AddCompare,
                                 touchdown::cli::AddEstimate,  touchdown::cli::AddFly,     touchdown::cli::AddPad,
                                 touchdown::cli::AddPaper,     touchdown::cli::AddReport,  touchdown::cli::AddScore,
                                 touchdown::cli::AddStatus,    touchdown::cli::AddSweep,   touchdown::cli::AddSweepTask,
                                 touchdown::cli::AddTest,      touchdown::cli::AddTrain};

int RunAndExplain(const Run& run) {
  try {
    const int status = run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw std::runtime_error("cannot write to the standard output");
    return status;
  } catch (const touchdown::InputError& error) {
    spdlog::error("{}", error.what());
    return ExitStatus::kBadInput;
  } catch (const touchdown::util::Interrupted&) {
    spdlog::warn("interrupted, nothing was written");
    return ExitStatus::kInterrupted;
  } catch (const std::exception& error) {
    spdlog::error("internal error: {}", error.what());
    return ExitStatus::kInternalError;
  }
}

}  // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("touchdown"));
  spdlog::set_pattern("%^%l%$: %v");
  touchdown::cli::CatchInterrupts();
  // Silence OpenCV and FFmpeg, which print their own messages about unreadable files in addition to ours.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  setenv("OPENCV_LOG_LEVEL", "OFF", 0);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);  // A flight uses one core, so that several can run in parallel.

  CLI::App app("A closed-loop testbed for vision-based quadrotor landing", "touchdown");
  app.set_version_flag("--version", std::string(touchdown::util::Version()));
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return std::string("error: ") + error.what() + " (see touchdown --help)\n";
  });
  Run run;
  for (AddCommand* const add : kCommands) add(app, run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitStatus::kPassed : ExitStatus::kBadInput;
  }
  return RunAndExplain(run);
}
