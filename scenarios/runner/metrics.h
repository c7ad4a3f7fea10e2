#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

struct FlightLog;

/// A pad that is detected farther than this from the true one is a false one.
inline constexpr double kFalsePad_px = 30.0;

/// A metric's stable name and meaning.
struct MetricInfo {
  std::string_view name;
  std::string_view unit;  ///< "" for none.
  std::string_view doc;
  bool larger_is_better = false;
};

/// All metrics that there are, in the order in which they are shown.
std::span<const MetricInfo> AllMetrics();

/// nullptr for a name that is none.
const MetricInfo* FindMetric(std::string_view name);

/// By name; a metric that the flight does not have is absent.
using Metrics = std::map<std::string, double, std::less<>>;

/// The metrics of a flight, as AllMetrics defines them.
Metrics ComputeMetrics(const FlightLog& log);

struct FrameRecord;

/// The errors among them, of the frames with status ok: estimate.*_rmse_*.
Metrics PoseErrors(std::span<const FrameRecord> frames);

/// How well the pad was found: estimate.availability, estimate.ring_frames, estimate.false_pads.
Metrics Detection(std::span<const FrameRecord> frames);

/// One demand on a flight, and whether it was kept.
struct Check {
  std::string name = {};             ///< Of the metric, or "outcome".
  std::optional<double> value = {};  ///< nullopt for a metric that the flight does not have, and for the outcome.
  std::string text = {};             ///< The outcome; empty for a metric.
  std::string unit = {};
  std::string limit = {};  ///< "<= 0.06", ">= 0.95", "0 .. 3", "landed".
  bool pass = false;
};

/// "<= 0.06", ">= 0.95", "0 .. 3".
std::string LimitText(const Criterion& criterion);

/// The outcome against the one that the scenario expects, then each criterion in its order.
std::vector<Check> Judge(const Scenario& scenario, Outcome outcome, const Metrics& metrics);

}  // namespace touchdown::runner
