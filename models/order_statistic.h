#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

namespace touchdown::models {

/// Order statistic: the value at index `rank` of the sorted values. `rank` must be less than their number.
template <std::ranges::input_range Values>
auto OrderStatistic(const Values& values, std::size_t rank) {
  std::vector<std::ranges::range_value_t<Values>> sorted(std::ranges::begin(values), std::ranges::end(values));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

/// Median of at least one value. For an even number of values it is the larger of the middle two.
template <std::ranges::input_range Values>
auto UpperMedian(const Values& values) {
  return OrderStatistic(values, std::ranges::size(values) / 2);
}

}  // namespace touchdown::models
