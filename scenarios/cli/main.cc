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
#include "scenarios/flight/interrupted.h"

namespace {

using touchdown::scenarios::AddCommand;
using touchdown::scenarios::ExitStatus;
using touchdown::scenarios::Run;

AddCommand* const kCommands[] = {
    touchdown::scenarios::AddCalibrate, touchdown::scenarios::AddCollect, touchdown::scenarios::AddCompare,
    touchdown::scenarios::AddEstimate,  touchdown::scenarios::AddFly,     touchdown::scenarios::AddPad,
    touchdown::scenarios::AddPaper,     touchdown::scenarios::AddReport,  touchdown::scenarios::AddScore,
    touchdown::scenarios::AddStatus,    touchdown::scenarios::AddSweep,   touchdown::scenarios::AddSweepTask,
    touchdown::scenarios::AddTest,      touchdown::scenarios::AddTrain};

int RunAndExplain(const Run& run) {
  try {
    const int status = run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw std::runtime_error("the standard output cannot be written");
    return status;
  } catch (const touchdown::InputError& error) {
    spdlog::error("{}", error.what());
    return ExitStatus::kBadInput;
  } catch (const touchdown::scenarios::Interrupted&) {
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
  touchdown::scenarios::CatchInterrupts();
  // OpenCV and the libraries under it would tell of files that cannot be read in words of their own, beside ours.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  setenv("OPENCV_LOG_LEVEL", "OFF", 0);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);  // A flight keeps to one core: many fly side by side.

  CLI::App app("A closed-loop testbed for vision-based quadrotor landing", "touchdown");
  app.set_version_flag("--version", TOUCHDOWN_VERSION);
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
