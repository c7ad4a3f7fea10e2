#pragma once

#include <span>
#include <vector>

namespace touchdown::util {

/// Value with its 95 % confidence interval.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Mean of at least one value.
double Mean(std::span<const double> values);
/// Root mean square of at least one value.
double RootMeanSquare(std::span<const double> values);
/// Sample standard deviation (divisor n - 1); 0 for a single value.
double StandardDeviation(std::span<const double> values);
/// Quantile `q` of at least one value, interpolated between order statistics.
double Quantile(std::span<const double> values, double q);

/// Quantile with its distribution-free interval from order statistics (David and Nagaraja 2003, section 7.1). A bound
/// that the number of values does not determine is infinite. For `clusters` see WilsonInterval.
Interval QuantileInterval(std::vector<double> values, double q, int clusters);

/// Smallest number of values for which both bounds of the interval of quantile `q`, in (0, 1), are finite.
int FewestForQuantile(double q);

/// Quantile (inverse CDF) of the standard normal distribution.
double NormalQuantile(double probability);
/// Quantile of Student's t distribution.
double StudentsTQuantile(double probability, int degrees_of_freedom);

/// P(X >= min_successes) for X ~ Binomial(trials, probability).
double BinomialTail(int min_successes, int trials, double probability);

/// Mean of n values with its interval by Student's t with n - 1 degrees of freedom. For n = 1 both bounds are the
/// value.
Interval MeanInterval(std::span<const double> values);

/// Rate of `successes` in `trials` with Wilson's score interval (Wilson 1927), which is valid at 0 and 1 too. `trials`
/// must be positive.
Interval WilsonInterval(int successes, int trials);

/// Wilson's score interval for correlated trials, such as flights of the same seed. The trials form `clusters` groups.
/// Each group counts as a single trial, which is a lower bound of its information. `clusters` is between 1 and
/// `trials`.
Interval WilsonInterval(int successes, int trials, int clusters);

}  // namespace touchdown::util
