#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/util/interrupted.h"

namespace touchdown::experiments {

using Json = nlohmann::ordered_json;

/// A piece of an experiment that is measured by itself: a flight, a scene. It depends on nothing but its own inputs, so
/// that pieces run side by side in any order, and one that is done need not be done again.
struct Measurement {
  std::string id = {};      ///< Letters, digits, _ and -; unlike any other's.
  double expected_s = 1.0;  ///< Of a core, about: for the order and the time to go.
  bool alone = false;       ///< Nothing else may run meanwhile: it measures time.
  std::function<Json(const util::StopRequested& stop_requested)> take = {};  ///< It may throw Interrupted.
};

/// What was measured, by the measurements' ids.
using Measured = std::map<std::string, Json>;

}  // namespace touchdown::experiments
