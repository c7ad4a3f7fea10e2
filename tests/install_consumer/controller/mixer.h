// Header of the vehicle's own program, with the same path as a header of the flight libraries.
#pragma once

#include <array>

namespace consumer {

/// Speeds of four motors, rad/s, as the fractions 0 to 1 of full speed that the vehicle's motor controllers accept.
class Mixer {
 public:
  explicit Mixer(double full_speed_rad_s) : full_speed_rad_s_(full_speed_rad_s) {}

  std::array<double, 4> Fractions(const std::array<double, 4>& speed_rad_s) const {
    std::array<double, 4> fractions;
    for (std::size_t i = 0; i < fractions.size(); ++i) fractions[i] = speed_rad_s[i] / full_speed_rad_s_;
    return fractions;
  }

 private:
  double full_speed_rad_s_;
};

}  // namespace consumer
