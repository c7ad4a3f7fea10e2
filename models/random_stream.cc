#include "models/random_stream.h"

#include <cmath>

namespace touchdown::models {
namespace {

/// SplitMix64 (Steele et al., 2014): spreads every input bit over the whole output.
std::uint64_t Mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t StreamSeed(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = Mix(seed);
  for (const char c : name) hash = Mix(hash ^ static_cast<unsigned char>(c));
  return hash;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) : engine_(StreamSeed(seed, name)) {}

double RandomStream::Uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

int RandomStream::UniformInt(int low, int high) {
  const auto count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
  return low + static_cast<int>(static_cast<std::uint64_t>(Uniform() * static_cast<double>(count)));
}

double RandomStream::Normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u, v, s;
  do {
    u = Uniform(-1.0, 1.0);
    v = Uniform(-1.0, 1.0);
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = v * scale;
  has_spare_ = true;
  return u * scale;
}

Eigen::Vector3d RandomStream::NormalVector3() {
  const double x = Normal(), y = Normal(), z = Normal();
  return {x, y, z};
}

}  // namespace touchdown::models
