#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "models/describe.h"
#include "models/random_stream.h"
#include "models/signals.h"
#include "sim/dynamics/true_state.h"

namespace touchdown::sim {

class World;

/// Parameters of the laser range finder that looks along the body's -Z axis.
struct RangeFinderConfig {
  int rate_hz = 50;
  Eigen::Vector3d position_m = Eigen::Vector3d(0.05, 0.0, -0.03);  ///< In B.
  double min_range_m = 0.05;
  double max_range_m = 8.0;
  double noise_m = 0.01;

  /// Throws InputError for a value out of its range (see Describe), or when the rate does not divide `time`'s.
  void Validate(const models::TimeBase& time) const;
};

void Describe(models::ConfigVisitor& v, RangeFinderConfig& config);

/// Simulated laser range finder with a beam of zero width and white noise. It measures the distance to the nearest
/// visible surface, see World::DistanceAlong.
class RangeFinder {
 public:
  using Config = RangeFinderConfig;
  using Reading = models::RangeReading;
  static constexpr const char* kName = "range_finder";
  static constexpr const char* kDoc = "Downward laser range finder, whose readings are written to range_finder.csv.";
  static constexpr const char* kColumns = "range_m";
  static std::array<double, 1> Columns(const Reading& reading) { return {reading.range_m}; }

  /// `world` must outlive the sensor. Draws noise from the stream "range_finder.noise". Throws InputError for an
  /// invalid config.
  RangeFinder(const RangeFinderConfig& config, const World& world, const models::TimeBase& time, std::uint64_t seed);

  /// Call once per tick, in order; returns a reading on the ticks of its rate if it is within the limits of the range.
  std::optional<models::RangeReading> Sample(const TrueState& truth);

 private:
  RangeFinderConfig config_;
  const World* world_;
  models::Tick period_;
  models::RandomStream noise_;
};

}  // namespace touchdown::sim
