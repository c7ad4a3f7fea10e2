#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <string_view>

namespace touchdown::models {

/// A source of random numbers, derived from the flight's seed and the name of the stream ("imu", "camera.noise",
/// "wind"). Each consumer has its own stream, so that adding one does not change the numbers of the others.
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

  /// True with the given probability.
  bool Bernoulli(double probability) { return Uniform() < probability; }

  /// 64 random bits.
  std::uint64_t Bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace touchdown::models
