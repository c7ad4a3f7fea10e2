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
#include "scenarios/cli/calibrate.h"
#include "scenarios/cli/collect.h"
#include "scenarios/cli/command.h"
#include "scenarios/cli/compare.h"
#include "scenarios/cli/estimate.h"
#include "scenarios/cli/fly.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/pad.h"
#include "scenarios/cli/paper.h"
#include "scenarios/cli/report.h"
#include "scenarios/cli/score.h"
#include "scenarios/cli/status.h"
#include "scenarios/cli/sweep.h"
#include "scenarios/cli/sweep_task.h"
#include "scenarios/cli/test.h"
#include "scenarios/cli/train.h"
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
      throw std::runtime_error("the standard output cannot be written");
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
  // OpenCV and the libraries under it would tell of files that cannot be read in words of their own, beside ours.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  setenv("OPENCV_LOG_LEVEL", "OFF", 0);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);  // A flight keeps to one core: many fly side by side.

  CLI::App app("A closed-loop testbed for vision-based quadrotor landing", "touchdown");
  app.set_version_flag("--version", std::string(touchdown::util::Version()));
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return std::string("error: ") + error.what() + " (touchdown --help tells more)\n";
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
