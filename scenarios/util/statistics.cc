#include "scenarios/util/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "models/order_statistic.h"

namespace touchdown::util {
namespace {

constexpr double kUpper = 0.975;  // Upper quantile of a two-sided 95 % interval.

void RequireSome(std::size_t count) {
  if (count == 0) throw std::invalid_argument("there are no values");
}

void RequireClusters(int clusters, std::size_t trials) {
  if (clusters < 1 || static_cast<std::size_t>(clusters) > trials)
    throw std::invalid_argument("the number of clusters must be between 1 and the number of trials");
}

}  // namespace

double Mean(std::span<const double> values) {
  RequireSome(values.size());
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double RootMeanSquare(std::span<const double> values) {
  RequireSome(values.size());
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double StandardDeviation(std::span<const double> values) {
  const double mean = Mean(values);
  if (values.size() == 1) return 0.0;
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double Quantile(std::span<const double> values, double q) {
  RequireSome(values.size());
  const double place = std::clamp(q, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(models::OrderStatistic(values, below), models::OrderStatistic(values, above),
                   place - static_cast<double>(below));
}

Interval QuantileInterval(std::vector<double> values, double q, int clusters) {
  Interval interval{Quantile(values, q), -std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
  RequireClusters(clusters, values.size());
  std::sort(values.begin(), values.end());
  const auto count = static_cast<std::size_t>(clusters);
  // Number of clusters below the true quantile.
  const boost::math::binomial below(static_cast<double>(clusters), std::clamp(q, 0.0, 1.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double at_most_i = boost::math::cdf(below, static_cast<double>(i));
    if (at_most_i <= 1.0 - kUpper) interval.low = values[i * values.size() / count];
    if (at_most_i >= kUpper) {
      interval.high = values[((i + 1) * values.size() + count - 1) / count - 1];
      break;
    }
  }
  return interval;
}

int FewestForQuantile(double q) {
  // The probability that all values are on one side of the quantile must be at most 1 - kUpper.
  const double larger = std::max(q, 1.0 - q);
  if (!(larger < 1.0))
    throw std::invalid_argument("the interval of a quantile of 0 or 1 is not bounded by any number of values");
  return static_cast<int>(std::ceil(std::log(1.0 - kUpper) / std::log(larger)));
}

double NormalQuantile(double probability) { return boost::math::quantile(boost::math::normal(), probability); }

double StudentsTQuantile(double probability, int degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double BinomialTail(int min_successes, int trials, double probability) {
  if (min_successes <= 0) return 1.0;
  return boost::math::cdf(boost::math::complement(boost::math::binomial(trials, probability), min_successes - 1));
}

Interval MeanInterval(std::span<const double> values) {
  const double mean = Mean(values);
  if (values.size() == 1) return {mean, mean, mean};
  const auto count = static_cast<double>(values.size());
  const double t = StudentsTQuantile(kUpper, static_cast<int>(values.size()) - 1);
  const double half = t * StandardDeviation(values) / std::sqrt(count);
  return {mean, mean - half, mean + half};
}

Interval WilsonInterval(int successes, int trials) { return WilsonInterval(successes, trials, trials); }

Interval WilsonInterval(int successes, int trials, int clusters) {
  if (trials < 1 || successes < 0 || successes > trials)
    throw std::invalid_argument("invalid number of successes or trials");
  RequireClusters(clusters, static_cast<std::size_t>(trials));
  const double n = clusters, p = static_cast<double>(successes) / trials;
  const double z = NormalQuantile(kUpper);
  const double center = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {p, successes == 0 ? 0.0 : center - half, successes == trials ? 1.0 : center + half};
}

}  // namespace touchdown::util
