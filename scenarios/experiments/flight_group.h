#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/experiments/experiment.h"

namespace touchdown::experiments {

/// Statistics over flights of one kind, each summarized by FlyAndSummarize(). An error is selected by its `key`, as in
/// kTableOne, and by its `reference`: the "truth", the "tracking" system, or the truth with "integer" contour points.
class FlightGroup {
 public:
  /// `measured` must contain all `ids`.
  FlightGroup(const Measured& measured, const std::vector<std::string>& ids);

  int count() const { return static_cast<int>(flights_.size()); }
  const std::vector<Json>& flights() const { return flights_; }
  int ended_as_expected() const;
  /// Number of frames of all flights in which the estimator found a pad where there is none.
  int false_pads() const;

  /// The values of an entry such as "flight.max_tilt_deg", of the flights that have it.
  std::vector<double> Values(const std::string& name) const;
  /// The errors of the flights that have one.
  std::vector<double> Errors(const std::string& reference, const std::string& key) const;
  /// Mean of Errors(), or nullopt if there are none.
  std::optional<double> MeanError(const std::string& reference, const std::string& key) const;

  /// Table row: `name`, then the mean error for each of kErrorKeys, or "none".
  std::vector<std::string> ErrorRow(const std::string& name, const std::string& reference) const;

  /// Summary row: the number of flights that did not end with the expected outcome. The paper reports none.
  ComparedQuantity Failures(const std::string& which) const;

 private:
  std::vector<Json> flights_;
};

inline constexpr std::array<const char*, 5> kErrorKeys = {"xy_mm", "z_mm", "roll_deg", "pitch_deg", "yaw_deg"};

/// Header of a table whose rows are ErrorRow().
std::vector<std::string> ErrorHead(const std::string& first);

}  // namespace touchdown::experiments
