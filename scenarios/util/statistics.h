#pragma once

#include <span>
#include <vector>

namespace touchdown::util {

/// A value with its 95 % confidence interval.
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

/// Quantile with its distribution-free interval from order statistics (David and
/// Nagaraja 2003, section 7.1): an end that the values do not bound is infinite. `clusters`: see WilsonInterval.
Interval QuantileInterval(std::vector<double> values, double q, int clusters);

/// Smallest number of values that bound both ends of the interval of quantile `q`, in (0, 1).
int FewestForQuantile(double q);

/// Normal quantile (inverse CDF), and quantile of Student's t distribution.
double NormalQuantile(double probability);
double StudentsTQuantile(double probability, int degrees_of_freedom);

/// P(X >= least) for X ~ Binomial(trials, probability).
double BinomialTail(int least, int trials, double probability);

/// Mean with its interval by Student's t with n - 1 degrees of freedom; the interval of a single value is the value.
Interval MeanInterval(std::span<const double> values);

/// Rate of `successes` in `trials` with Wilson's score interval (Wilson 1927), which is valid at 0 and 1, too. `trials`
/// must be positive.
Interval WilsonInterval(int successes, int trials);

/// Same for trials in clusters that may succeed or fail together, as the flights of one seed: each cluster counts as a
/// single trial, a lower bound of its information. `clusters` is between 1 and `trials`.
Interval WilsonInterval(int successes, int trials, int clusters);

}  // namespace touchdown::util
