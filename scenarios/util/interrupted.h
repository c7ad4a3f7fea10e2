#pragma once

#include <functional>
#include <stdexcept>

namespace touchdown::util {

/// Thrown when the user requests a stop. No file is left half-written. The program exits with status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Polled by long operations, which throw Interrupted when it returns true.
using StopRequested = std::function<bool()>;

}  // namespace touchdown::util
