#include "sim/scene/lattice_noise.h"

#include <utility>

namespace touchdown::sim {
namespace {

constexpr std::uint32_t kColumnFactor = 0x9E3779B1u;
constexpr std::uint32_t kRowFactor = 0x85EBCA77u;

/// Hash of `h`, in [0, 1).
double Scrambled(std::uint32_t h) {
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  h ^= h >> 15;
  return h * 0x1p-32;
}

/// Floor and remainder. Without SSE 4.1, a call of std::floor would take most of the time of SmoothNoise.
std::pair<std::int32_t, double> WholeAndRest(double x) {
  const std::int32_t towards_zero = static_cast<std::int32_t>(x);
  const std::int32_t whole = towards_zero - (towards_zero > x ? 1 : 0);
  return {whole, x - whole};
}

double Smoothstep(double t) { return t * t * (3.0 - 2.0 * t); }

double Blend(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

double CellValue(double x, double y, std::uint32_t seed) {
  const auto column = static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
  const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(y));
  return Scrambled(seed ^ (column * kColumnFactor) ^ (row * kRowFactor));
}

double SmoothNoise(double x, double y, std::uint32_t seed) {
  const auto [whole_x, rest_x] = WholeAndRest(x);
  const auto [whole_y, rest_y] = WholeAndRest(y);
  const std::uint32_t left = static_cast<std::uint32_t>(whole_x) * kColumnFactor, right = left + kColumnFactor;
  const std::uint32_t bottom = seed ^ (static_cast<std::uint32_t>(whole_y) * kRowFactor);
  const std::uint32_t top = seed ^ (static_cast<std::uint32_t>(whole_y + 1) * kRowFactor);
  const double along = Smoothstep(rest_x);
  const double low = Blend(Scrambled(bottom ^ left), Scrambled(bottom ^ right), along);
  const double high = Blend(Scrambled(top ^ left), Scrambled(top ^ right), along);
  return 2.0 * Blend(low, high, Smoothstep(rest_y)) - 1.0;
}

double FractalNoise(double x, double y, int octaves, std::uint32_t seed) {
  double sum = 0.0, gain = 0.5;
  for (int i = 0; i < octaves; ++i) {
    sum += gain * SmoothNoise(x, y, seed + static_cast<std::uint32_t>(i));
    x *= 2.03;
    y *= 2.03;
    gain *= 0.5;
  }
  return sum;
}

}  // namespace touchdown::sim
