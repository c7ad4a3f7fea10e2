#include "estimator/paper/components.h"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstring>

#include "models/error.h"

namespace touchdown::estimator::paper {
namespace {

/// Equivalent label sets of He et al. Each provisional label maps to the representative of its set, which is the
/// smallest label. The labels of a set form a linked list, so that a merge relabels the set with the larger
/// representative at once.
class LabelSets {
 public:
  int Add() {
    const int label = static_cast<int>(representative_.size());
    representative_.push_back(label);
    next_.push_back(kNone);
    tail_.push_back(label);
    return label;
  }

  void Merge(int a, int b) {
    int kept = representative_[a], merged = representative_[b];
    if (kept == merged) return;
    if (kept > merged) std::swap(kept, merged);
    for (int label = merged; label != kNone; label = next_[label]) representative_[label] = kept;
    next_[tail_[kept]] = merged;
    tail_[kept] = tail_[merged];
  }

  int Representative(int label) const { return representative_[label]; }
  int size() const { return static_cast<int>(representative_.size()); }

 private:
  static constexpr int kNone = -1;
  std::vector<int> representative_, next_, tail_;
};

struct LabeledRuns {
  std::vector<Run> runs;
  std::vector<int> labels;  // Provisional label of each run.
  LabelSets sets;
};

void AppendRunsOfRow(const models::ImageView& dark, int v, std::vector<Run>& runs) {
  const std::uint8_t* row = dark.Row(v);
  for (int u = 0; u < dark.width;) {
    std::uint64_t eight;
    while (u + 8 <= dark.width && (std::memcpy(&eight, row + u, 8), eight == 0)) u += 8;
    while (u < dark.width && row[u] == 0) ++u;
    if (u == dark.width) return;
    const int begin = u;
    while (u < dark.width && row[u] != 0) ++u;
    runs.push_back({v, begin, u});
  }
}

LabeledRuns FirstScan(const models::ImageView& dark) {
  LabeledRuns scan;
  std::size_t above_begin = 0, above_end = 0;
  for (int v = 0; v < dark.height; ++v) {
    const std::size_t row_begin = scan.runs.size();
    AppendRunsOfRow(dark, v, scan.runs);
    std::size_t above = above_begin;
    for (std::size_t i = row_begin; i < scan.runs.size(); ++i) {
      const Run& run = scan.runs[i];
      int label = -1;
      while (above < above_end && scan.runs[above].u_end < run.u_begin) ++above;
      for (; above < above_end && scan.runs[above].u_begin <= run.u_end; ++above) {
        if (label < 0) {
          label = scan.sets.Representative(scan.labels[above]);
        } else {
          scan.sets.Merge(label, scan.labels[above]);
        }
        // A run that extends beyond this one may also touch the next one.
        if (scan.runs[above].u_end > run.u_end) break;
      }
      scan.labels.push_back(label < 0 ? scan.sets.Add() : label);
    }
    above_begin = row_begin;
    above_end = scan.runs.size();
  }
  return scan;
}

/// Bounding box and size of a component.
struct Extent {
  int u_min = INT_MAX, u_max = 0, v_min = INT_MAX, v_max = 0, area = 0;
  std::size_t run_count = 0;

  void Include(const Run& run) {
    u_min = std::min(u_min, run.u_begin);
    u_max = std::max(u_max, run.u_end);
    v_min = std::min(v_min, run.v);
    v_max = std::max(v_max, run.v + 1);
    area += run.u_end - run.u_begin;
    ++run_count;
  }

  bool IsTooSmall(const ComponentsConfig& config) const {
    const int width = u_max - u_min, height = v_max - v_min;
    return std::max(width, height) < config.min_long_side_px || std::min(width, height) < config.min_short_side_px ||
           area < config.min_area_px;
  }
};

}  // namespace

void ComponentsConfig::Validate() const {
  if (min_long_side_px <= 0 || min_short_side_px <= 0 || min_area_px <= 0) {
    throw InputError("min_long_side_px, min_short_side_px and min_area_px must be at least 1");
  }
}

ComponentSet ExtractComponents(const models::ImageView& dark, const ComponentsConfig& config) {
  const LabeledRuns scan = FirstScan(dark);
  std::vector<Extent> extents(static_cast<std::size_t>(scan.sets.size()));
  for (std::size_t i = 0; i < scan.runs.size(); ++i) {
    extents[static_cast<std::size_t>(scan.sets.Representative(scan.labels[i]))].Include(scan.runs[i]);
  }

  ComponentSet result;
  result.image_width = dark.width;
  result.image_height = dark.height;
  constexpr std::size_t kDropped = SIZE_MAX;
  std::vector<std::size_t> next_slot(extents.size(), kDropped);
  std::size_t run_total = 0;
  for (std::size_t label = 0; label < extents.size(); ++label) {
    const Extent& extent = extents[label];
    if (extent.run_count == 0 || extent.IsTooSmall(config)) continue;
    result.components.push_back({extent.u_min, extent.v_min, extent.u_max - extent.u_min, extent.v_max - extent.v_min,
                                 extent.area, run_total, extent.run_count});
    next_slot[label] = run_total;
    run_total += extent.run_count;
  }
  result.runs.resize(run_total);
  for (std::size_t i = 0; i < scan.runs.size(); ++i) {
    std::size_t& slot = next_slot[static_cast<std::size_t>(scan.sets.Representative(scan.labels[i]))];
    if (slot != kDropped) result.runs[slot++] = scan.runs[i];
  }
  return result;
}

}  // namespace touchdown::estimator::paper
