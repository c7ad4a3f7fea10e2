#include "sim/lattice_noise.h"

#include <cmath>

namespace touchdown::sim {
namespace {

std::uint32_t Hash(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h =
      seed ^ (static_cast<std::uint32_t>(x) * 0x9E3779B1u) ^ (static_cast<std::uint32_t>(y) * 0x85EBCA77u);
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  return h ^ (h >> 15);
}

}  // namespace

double CellValue(double x, double y, std::uint32_t seed) {
  return Hash(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), seed) * 0x1p-32;
}

double SmoothNoise(double x, double y, std::uint32_t seed) {
  const double cx = std::floor(x), cy = std::floor(y);
  const double fx = x - cx, fy = y - cy;
  const double sx = fx * fx * (3.0 - 2.0 * fx), sy = fy * fy * (3.0 - 2.0 * fy);
  const double low = std::lerp(CellValue(cx, cy, seed), CellValue(cx + 1, cy, seed), sx);
  const double high = std::lerp(CellValue(cx, cy + 1, seed), CellValue(cx + 1, cy + 1, seed), sx);
  return 2.0 * std::lerp(low, high, sy) - 1.0;
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
