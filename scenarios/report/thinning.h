#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchdown::report {

/// One value per time of a plot; nullopt where there is no value.
using Series = std::vector<std::optional<double>>;

/// Selects the rows to plot from series that share their times, so that the plot looks the same as with all rows. The
/// rows are divided into `buckets` buckets of equal size. The selection contains the first and the last row and, for
/// each series, the smallest and the largest value of each bucket and the rows on both sides of each gap boundary. All
/// rows are selected when there are at most four per bucket. Returns indices in ascending order.
std::vector<std::size_t> ThinnedRows(std::span<const Series> series, std::size_t buckets);

}  // namespace touchdown::report
