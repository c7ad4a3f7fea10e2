#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchdown::report {

/// One value for each of a plot's times; nullopt where there is none.
using Series = std::vector<std::optional<double>>;

/// The rows to keep of series that share their times, so that a drawing of them looks as one of all rows: of each of
/// `buckets` runs of equally many rows every series' smallest and largest value, and everywhere the rows on both sides
/// of a gap's edge. All rows when there are no more than four for each bucket. In rising order.
std::vector<std::size_t> ThinnedRows(std::span<const Series> series, std::size_t buckets);

}  // namespace touchdown::report
