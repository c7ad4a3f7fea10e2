#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/util/interrupted.h"

namespace touchdown::experiments {

using Json = nlohmann::ordered_json;

/// An independent part of an experiment, such as a flight or a scene. It depends only on its own inputs, so
/// measurements can run in parallel in any order, and their results can be reused.
struct Measurement {
  std::string id = {};      ///< Unique; letters, digits, _ and -.
  double expected_s = 1.0;  ///< Approximate time on one core, for scheduling and progress.
  bool alone = false;       ///< No other measurement may run at the same time, because this one measures time.
  std::function<Json(const util::StopRequested& stop_requested)> measure = {};  ///< May throw Interrupted.
};

/// Results by measurement id.
using Measured = std::map<std::string, Json>;

}  // namespace touchdown::experiments
