#pragma once

#include <functional>
#include <stdexcept>

namespace touchdown::util {

/// The user asked to stop. Nothing is left half-written. The program ends with status 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Asked every now and then by long work; true makes it throw Interrupted.
using StopRequested = std::function<bool()>;

}  // namespace touchdown::util
