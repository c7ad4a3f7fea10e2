#include "scenarios/report/thinning.h"

#include <algorithm>

namespace touchdown::report {
namespace {

constexpr std::size_t kMaxUnthinnedRowsPerBucket = 4;

void KeepExtremes(const Series& series, std::size_t begin, std::size_t end, std::vector<bool>& kept) {
  std::optional<std::size_t> smallest, largest;
  for (std::size_t row = begin; row < end; ++row) {
    if (!series[row]) continue;
    if (!smallest || *series[row] < *series[*smallest]) smallest = row;
    if (!largest || *series[row] > *series[*largest]) largest = row;
  }
  if (smallest) kept[*smallest] = kept[*largest] = true;
}

void KeepGapBoundaries(const Series& series, std::vector<bool>& kept) {
  for (std::size_t row = 1; row < series.size(); ++row) {
    if (series[row].has_value() != series[row - 1].has_value()) kept[row - 1] = kept[row] = true;
  }
}

}  // namespace

std::vector<std::size_t> ThinnedRows(std::span<const Series> series, std::size_t buckets) {
  const std::size_t rows = series.empty() ? 0 : series.front().size();
  std::vector<bool> kept(rows, rows <= buckets * kMaxUnthinnedRowsPerBucket);
  if (rows > buckets * kMaxUnthinnedRowsPerBucket) {
    kept.front() = kept.back() = true;
    for (const Series& one : series) {
      for (std::size_t i = 0; i < buckets; ++i) KeepExtremes(one, i * rows / buckets, (i + 1) * rows / buckets, kept);
      KeepGapBoundaries(one, kept);
    }
  }
  std::vector<std::size_t> thinned;
  for (std::size_t row = 0; row < rows; ++row) {
    if (kept[row]) thinned.push_back(row);
  }
  return thinned;
}

}  // namespace touchdown::report
