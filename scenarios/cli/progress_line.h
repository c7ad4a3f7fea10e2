#pragma once

#include <string>

#include "scenarios/flight/stopwatch.h"

namespace touchdown::scenarios {

/// A line on the terminal that tells how far long work is. Elsewhere than on a terminal it stays silent.
class ProgressLine {
 public:
  ProgressLine();
  /// Clears the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether it is time for another Show: a few times a second on a terminal, never elsewhere.
  bool IsDue() const;
  void Show(const std::string& text);

 private:
  bool on_terminal_;
  bool shown_ = false;
  Stopwatch since_shown_;
};

}  // namespace touchdown::scenarios
