#pragma once

#include <cstdint>

/// Noise as a function of position and seed, for surfaces: defined everywhere, in any order.
namespace touchdown::sim {

/// Uniform over [0, 1), a function of the cell, whose coordinates are whole numbers.
double CellValue(double x, double y, std::uint32_t seed);

/// Smooth noise of unit wavelength in [-1, 1]: random values on the integer lattice, interpolated.
double SmoothNoise(double x, double y, std::uint32_t seed);

/// Octaves of smooth noise, each half as long and half as strong as the one before.
double FractalNoise(double x, double y, int octaves, std::uint32_t seed);

}  // namespace touchdown::sim
