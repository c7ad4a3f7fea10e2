#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <string_view>

namespace touchdown::models {

/// A separate source of random numbers for each consumer, derived from the flight's seed and the source's name
/// ("imu", "camera.noise", "wind"), so that adding a source does not shift the others.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  /// Uniform over [0, 1), with 53 random bits.
  double Uniform();
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

  /// Uniform over {low, ..., high}.
  int UniformInt(int low, int high);

  /// Standard normal (Marsaglia's polar method).
  double Normal();
  Eigen::Vector3d NormalVector3();

  bool Chance(double probability) { return Uniform() < probability; }

  std::uint64_t Bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace touchdown::models
