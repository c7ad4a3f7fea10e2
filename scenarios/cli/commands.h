#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace touchdown::cli {

/// Exit status of the program.
enum ExitStatus : int {
  kPassed = 0,         ///< The command succeeded, and its criteria were met.
  kFailed = 1,         ///< The command completed, but its criteria were not met.
  kBadInput = 2,       ///< The usage, an input or the output directory is invalid.
  kInternalError = 3,  ///< The simulation or the program failed.
  kInterrupted = 130,  ///< The user stopped the program, for example with Ctrl-C.
};

/// The selected command, called after the command line is parsed. Returns an ExitStatus. It may throw InputError
/// (kBadInput), Interrupted (kInterrupted) and any other exception (kInternalError); main() reports these to the user.
using Run = std::function<int()>;

/// Adds a subcommand to `app` whose callback sets `run`.
using AddCommand = void(CLI::App& app, Run& run);

/// `touchdown calibrate imu|camera|all SCENARIO --out DIR` runs the calibrations of Sec. III-D on the scenario's
/// vehicle. `touchdown calibrate imu --imu FILE --out DIR` calibrates from the samples of a real IMU.
AddCommand AddCalibrate;

/// `touchdown collect DIR [FROM]...` merges the rows of a sweep that was flown in parts or on a cluster.
AddCommand AddCollect;

/// `touchdown compare A B` compares two sweeps flight by flight, or two variants of one sweep.
AddCommand AddCompare;

/// `touchdown estimate INPUT [--camera CAMERA.yaml] [--pad PAD.yaml] [--imu FILE] [--vehicle VEHICLE.yaml]
/// [--estimator NAME] [--video] --out DIR` runs the estimator alone, on footage.
AddCommand AddEstimate;

/// `touchdown fly SCENARIO [--set key=value]... [--seed N] [--estimator NAME] [--video on|off] [--out DIR]` flies one
/// scenario, judges it and writes its files.
AddCommand AddFly;

/// `touchdown pad --out FILE.pdf|FILE.svg [--pad PAD.yaml]` writes a printable sheet of the landing pad, and next to it
/// the pad description.
AddCommand AddPad;

/// `touchdown paper --out DIR` measures all quantities that the paper reports.
AddCommand AddPaper;

/// `touchdown report DIR` rebuilds the report page of a flight or a sweep from the files in its directory.
AddCommand AddReport;

/// `touchdown score --poses FILE --truth DIR` compares any poses of a flight with its truth.
AddCommand AddScore;

/// `touchdown status DIR` prints the progress of a sweep.
AddCommand AddStatus;

/// `touchdown sweep SWEEP --out DIR` flies a scenario over parameters, variants and seeds.
AddCommand AddSweep;

/// `touchdown sweep-task DIR N` flies one chunk of a sweep. The Slurm tasks that `touchdown sweep --slurm` submits run
/// it; `touchdown --help` does not list it.
AddCommand AddSweepTask;

/// `touchdown test FOLDER` flies every scenario of a directory as a flight test.
AddCommand AddTest;

/// `touchdown train --out DIR [--letter h|rectangle] [--seed N]` renders the training set of the classifier, trains it,
/// and writes its C code and its confusion matrix on test scenes.
AddCommand AddTrain;

}  // namespace touchdown::cli
