#include "scenarios/sweeper/analysis/pass_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace touchdown::sweeper {
namespace {

constexpr int kSteps = 121, kWidths = 17;
// Widths as fractions of [min, max]: from a step between neighboring locations to a slope over the whole range.
constexpr double kNarrowest = 0.005, kWidest = 0.5;
constexpr std::array<double, 3> kLapses = {0.002, 0.02, 0.06};

/// Argument of the logistic function 1 / (1 + exp(x)), which falls from 1 to 0.
double Falling(double x) { return 1.0 / (1.0 + std::exp(x)); }

}  // namespace

PassBoundary::PassBoundary(double min, double max, double level) : min_(min), max_(max) {
  const double range = max - min;
  for (int step = 0; step < kSteps; ++step) {
    for (int i = 0; i < kWidths; ++i) {
      for (const double lapse : kLapses) {
        if (level >= 1.0 - lapse) continue;  // This curve never reaches the level.
        const double x_at_level = std::log((1.0 - lapse) / level - 1.0);
        for (const double sign : {1.0, -1.0}) {
          const double location = min + range * step / (kSteps - 1);
          const double width = sign * range * kNarrowest * std::pow(kWidest / kNarrowest, i / (kWidths - 1.0));
          curves_.push_back({location, location - x_at_level * width, width, lapse, 0.0});
        }
      }
    }
  }
}

void PassBoundary::Add(double value, int passed, int failed) {
  constexpr double kMinProbability = 1e-12;
  for (Curve& curve : curves_) {
    const double pass_rate = (1.0 - curve.lapse) * Falling((value - curve.middle) / curve.width);
    if (passed > 0) curve.log_posterior += passed * std::log(std::max(kMinProbability, pass_rate));
    if (failed > 0) curve.log_posterior += failed * std::log(std::max(kMinProbability, 1.0 - pass_rate));
  }
}

double PassBoundary::Quantile(double probability) const {
  const double max_log = std::max_element(curves_.begin(), curves_.end(), [](const Curve& a, const Curve& b) {
                           return a.log_posterior < b.log_posterior;
                         })->log_posterior;
  std::array<double, kSteps> weights{};
  for (const Curve& curve : curves_) {
    const double step = (curve.location - min_) / (max_ - min_) * (kSteps - 1);
    weights[static_cast<std::size_t>(std::lround(step))] += std::exp(curve.log_posterior - max_log);
  }
  const double target = probability * std::accumulate(weights.begin(), weights.end(), 0.0);
  double sum = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    sum += weights[static_cast<std::size_t>(step)];
    if (sum >= target && step < kSteps - 1) return min_ + (max_ - min_) * step / (kSteps - 1);
  }
  return max_;
}

}  // namespace touchdown::sweeper
