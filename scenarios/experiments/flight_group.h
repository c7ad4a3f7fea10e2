#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/experiments/experiment.h"

namespace touchdown::experiments {

/// Flights of one kind, each summed up by FlyAndSumUp, to be told of together. An error is told by its `key`, as in
/// kTableOne, and by what it is `against`: the "truth", "tracking", or the truth with "integer" contour points.
class FlightGroup {
 public:
  /// All of `ids` must have been measured.
  FlightGroup(const Measured& measured, const std::vector<std::string>& ids);

  int count() const { return static_cast<int>(flights_.size()); }
  const std::vector<Json>& flights() const { return flights_; }
  int ended_as_expected() const;
  /// Frames, of all flights, in which a pad was seen where none was.
  int false_pads() const;

  /// An entry of the flights' own, such as "flight.max_tilt_deg", of those that have it.
  std::vector<double> Values(const std::string& name) const;
  /// Of the flights that have it.
  std::vector<double> Errors(const std::string& against, const std::string& key) const;
  /// nullopt where no flight has it.
  std::optional<double> MeanError(const std::string& against, const std::string& key) const;

  /// A table's row: the name, then the mean of each of kErrorKeys, "none" where no flight has it.
  std::vector<std::string> ErrorRow(const std::string& name, const std::string& against) const;

  /// A line of the summary: how many did not end as they should, of which the paper tells none.
  ComparedQuantity Failures(const std::string& which) const;

 private:
  std::vector<Json> flights_;
};

inline constexpr std::array<const char*, 5> kErrorKeys = {"xy_mm", "z_mm", "roll_deg", "pitch_deg", "yaw_deg"};

/// The head of a table of ErrorRow's rows.
std::vector<std::string> ErrorHead(const std::string& first);

}  // namespace touchdown::experiments
