#pragma once

#include <string>

#include "scenarios/util/stopwatch.h"

namespace touchdown::cli {

/// Prints the progress of a long task and the remaining time on stderr: one line that is updated in place on a
/// terminal, otherwise a log line every few seconds.
class Progress {
 public:
  /// `quiet` suppresses all output.
  explicit Progress(bool quiet);
  /// Clears the line on a terminal.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether the next Update() is due: at the start and five times a second on a terminal, otherwise every 5 s. Earlier
  /// calls of Update() are allowed.
  bool IsDue() const;

  /// Excludes the fraction of the work that an earlier run did, in [0, 1], from the estimate of the remaining time.
  void StartFrom(double fraction) { initial_fraction_ = fraction; }

  /// Prints the completed fraction of the work, in [0, 1], with `text`.
  void Update(double fraction, const std::string& text);

 private:
  bool quiet_;
  bool on_terminal_;
  bool shown_ = false;
  double initial_fraction_ = 0.0;
  util::Stopwatch since_start_;
  util::Stopwatch since_shown_;
};

}  // namespace touchdown::cli
