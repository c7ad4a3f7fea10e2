#pragma once

#include <span>
#include <vector>

namespace touchdown::util {

/// A value and the ends of the interval that holds the true one with 95 % confidence.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Of at least one value.
double Mean(std::span<const double> values);
/// Root of the mean of squares; of at least one value.
double RootMeanSquare(std::span<const double> values);
/// Sample standard deviation, with n - 1; 0 of a single value.
double StandardDeviation(std::span<const double> values);
/// The value below which a share `q` of them lies, interpolated between order statistics; of at least one value.
double Quantile(std::span<const double> values, double q);

/// The same, with the order statistics between which the true quantile lies whatever the distribution (David and
/// Nagaraja 2003, section 7.1): an end that the values do not bound is infinite. `clusters`: see WilsonInterval.
Interval QuantileInterval(std::vector<double> values, double q, int clusters);

/// Smallest number of values that bound both ends of the interval of quantile `q`, in (0, 1).
int FewestForQuantile(double q);

/// The value below which a standard normal variable stays with that chance; of Student's t on so many degrees of
/// freedom.
double NormalQuantile(double chance);
double StudentsTQuantile(double chance, int degrees_of_freedom);

/// That of so many trials, each with this chance, at least `least` succeed.
double BinomialTail(int least, int trials, double chance);

/// The mean, by Student's t on n - 1 degrees of freedom; a single value has no interval but itself.
Interval MeanInterval(std::span<const double> values);

/// The share of `successes` in `trials`, by Wilson's score interval (Wilson 1927), which holds at 0 and 1 too. `trials`
/// must be positive.
Interval WilsonInterval(int successes, int trials);

/// The same, of trials that come in clusters which may succeed or fail together, as the flights of one seed do: each
/// cluster counts as a single trial, the least that it can be worth. There are from one to as many as trials.
Interval WilsonInterval(int successes, int trials, int clusters);

}  // namespace touchdown::util
