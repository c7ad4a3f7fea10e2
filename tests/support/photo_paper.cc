#include "tests/support/photo_paper.h"

#include <algorithm>
#include <cmath>

#include "models/angles.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using models::kPi;

constexpr int kSteps = 1600, kMiddle = kSteps / 2;
constexpr double kStep = 0.005;

double PositionAtIndex(double index) { return (index - kMiddle) * kStep; }

}  // namespace

PhotoPaper::PhotoPaper(double radius_m, double severity, models::RandomStream& random) : radius_m_(radius_m) {
  const double heading = random.Uniform(-kPi, kPi);
  across_ = Vector2d(std::cos(heading), std::sin(heading));
  kind_ = severity > 0.0 ? random.UniformInt(0, 3) : 4;
  amount_ = severity * random.Uniform(0.4, 1.0) * (random.Bernoulli(0.5) ? 1.0 : -1.0);
  phase_ = random.Uniform(-kPi, kPi);
  period_ = random.Uniform(2.0, 4.5);
  begin_ = random.Uniform(0.0, 1.0);
  double length = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    lengths_.push_back(length);
    const double slope = Slope(PositionAtIndex(i + 0.5));
    length += kStep * std::sqrt(1.0 + slope * slope);
  }
  const double zero = lengths_[kSteps / 2];
  for (double& value : lengths_) value -= zero;
}

double PhotoPaper::Height(const Vector2d& p_W) const { return radius_m_ * HeightAt(Along(p_W)); }

Vector3d PhotoPaper::Normal(const Vector2d& p_W) const {
  const double slope = Slope(Along(p_W));
  return Vector3d(-slope * across_.x(), -slope * across_.y(), 1.0).normalized();
}

Vector2d PhotoPaper::SheetPoint(const Vector2d& p_W) const {
  const double q = Along(p_W);
  const double index = std::clamp(q / kStep + kMiddle, 0.0, kSteps - 1.001);
  const auto i = static_cast<std::size_t>(index);
  const double length = lengths_[i] + (index - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
  return p_W + across_ * (radius_m_ * (length - q));
}

double PhotoPaper::LargestHeight() const {
  double largest = 0.0;
  for (double q = -1.0; q <= 1.0; q += 0.02) largest = std::max(largest, std::abs(HeightAt(q)));
  return largest;
}

double PhotoPaper::Along(const Vector2d& p_W) const { return across_.dot(p_W) / radius_m_; }

double PhotoPaper::Raw(double q) const {
  switch (kind_) {
    case 0:  // Curled from a roll.
      return amount_ * q * q;
    case 1:  // Waves.
      return 0.5 * amount_ * std::sin(2.0 * kPi * q / period_ + phase_);
    case 2:  // A lifted side or corner.
      return q > begin_ ? 1.5 * std::abs(amount_) * (q - begin_) * (q - begin_) : 0.0;
    case 3:  // A crease.
      return amount_ * std::abs(q - 0.5 * begin_);
    default:
      return 0.0;
  }
}

double PhotoPaper::HeightAt(double q) const { return Raw(std::clamp(q, -2.0, 2.0)) - Raw(0.0); }

double PhotoPaper::Slope(double q) const { return (HeightAt(q + 1e-3) - HeightAt(q - 1e-3)) / 2e-3; }

}  // namespace touchdown::tests
