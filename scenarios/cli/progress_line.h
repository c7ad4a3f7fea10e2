#pragma once

#include <string>

#include "scenarios/flight/stopwatch.h"

namespace touchdown::scenarios {

/// Tells on stderr how far long work is: on a terminal a line that changes in place, elsewhere a plain line now and
/// then.
class ProgressLine {
 public:
  ProgressLine();
  /// Clears the line on a terminal.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether it is time for another Show: from the start and a few times a second on a terminal, elsewhere every few
  /// seconds.
  bool IsDue() const;
  void Show(const std::string& text);

 private:
  bool on_terminal_;
  bool shown_ = false;
  Stopwatch since_shown_;
};

}  // namespace touchdown::scenarios
