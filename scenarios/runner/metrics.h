#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

struct FlightLog;

/// Image distance between the detected and the true center of the pad above which the detection is a false pad.
inline constexpr double kFalsePad_px = 30.0;

/// Stable name and meaning of a metric.
struct MetricInfo {
  std::string_view name;
  std::string_view unit;  ///< "" for none.
  std::string_view doc;
  bool larger_is_better = false;
};

/// All metrics, in display order.
std::span<const MetricInfo> AllMetrics();

/// Metric with the given name; nullptr for an unknown name.
const MetricInfo* FindMetric(std::string_view name);

/// Values by name. A metric that the flight does not have is absent.
using Metrics = std::map<std::string, double, std::less<>>;

/// Metrics of a flight, as defined by AllMetrics.
Metrics ComputeMetrics(const FlightLog& log);

struct FrameRecord;

/// Pose errors of the frames with status ok: estimate.*_rmse_*.
Metrics PoseErrors(std::span<const FrameRecord> frames);

/// Detection metrics: estimate.availability, estimate.ring_frames, estimate.false_pads.
Metrics Detection(std::span<const FrameRecord> frames);

/// Result of one check of a flight.
struct Check {
  std::string name = {};             ///< Name of the metric, or "outcome".
  std::optional<double> value = {};  ///< nullopt for an absent metric and for the outcome.
  std::string text = {};             ///< The outcome; empty for a metric.
  std::string unit = {};
  std::string limit = {};  ///< "<= 0.06", ">= 0.95", "0 .. 3", "landed".
  bool pass = false;
};

/// Text of the limits of a criterion: "<= 0.06", ">= 0.95" or "0 .. 3".
std::string LimitText(const Criterion& criterion);

/// Checks a flight: first whether the outcome is the expected one, then the criteria in order.
std::vector<Check> Judge(const Scenario& scenario, Outcome outcome, const Metrics& metrics);

}  // namespace touchdown::runner
