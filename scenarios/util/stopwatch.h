#pragma once

#include <chrono>

namespace touchdown::util {

/// Measures the wall-clock time since its construction. Use it for timing reports only, not within the simulation.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  double milliseconds() const { return 1e3 * seconds(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace touchdown::util
