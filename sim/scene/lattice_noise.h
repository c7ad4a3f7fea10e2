#pragma once

#include <cstdint>

/// Noise for surfaces as a function of position and seed. It is defined everywhere and can be evaluated in any order.
namespace touchdown::sim {

/// Random value of the cell at integer coordinates, uniform over [0, 1).
double CellValue(double x, double y, std::uint32_t seed);

/// Smooth noise of unit wavelength in [-1, 1]: interpolated random values on the integer lattice.
double SmoothNoise(double x, double y, std::uint32_t seed);

/// Sum of octaves of smooth noise, each with half the wavelength and half the amplitude of the one before.
double FractalNoise(double x, double y, int octaves, std::uint32_t seed);

}  // namespace touchdown::sim
