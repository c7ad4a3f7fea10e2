#pragma once

#include <cmath>
#include <string>

#include "models/error.h"

namespace touchdown::controller {

/// Throws InputError unless `value` is finite and positive.
inline void RequirePositive(double value, const char* name) {
  if (!std::isfinite(value) || value <= 0.0) throw InputError(std::string(name) + " must be positive and finite");
}

/// Throws InputError unless `value` is finite and not negative.
inline void RequireNotNegative(double value, const char* name) {
  if (!std::isfinite(value) || value < 0.0) throw InputError(std::string(name) + " must be finite and not negative");
}

}  // namespace touchdown::controller
