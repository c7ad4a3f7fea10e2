#pragma once

#include <string>

#include "scenarios/util/stopwatch.h"

namespace touchdown::cli {

/// Tells on stderr how far long work is and when it will be done: on a terminal a line that changes in place, elsewhere
/// a plain line now and then.
class Progress {
 public:
  /// `quiet`: it tells nothing.
  explicit Progress(bool quiet);
  /// Clears the line on a terminal.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether it is time for another Tell: from the start and a few times a second on a terminal, elsewhere every few
  /// seconds. Telling sooner does no harm.
  bool IsDue() const;

  /// `share` of the work was done before: it does not tell how fast the rest goes.
  void GoOnFrom(double share) { before_ = share; }

  /// `share` of the work is done, in [0, 1].
  void Tell(double share, const std::string& text);

 private:
  bool quiet_;
  bool on_terminal_;
  bool shown_ = false;
  double before_ = 0.0;
  util::Stopwatch since_start_;
  util::Stopwatch since_shown_;
};

}  // namespace touchdown::cli
