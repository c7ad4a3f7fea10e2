#pragma once

#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Parameter of a sweep, an axis of its results.
struct SweepAxis {
  std::string key = {};
  std::vector<std::string> listed = {};  ///< As YAML; empty for one whose values are drawn.
};

/// Axes, limits and criteria of a sweep, by which its results are reported and judged. They are stored beside its rows.
struct SweepSpec {
  std::string name = {};
  std::string description = {};
  std::vector<SweepAxis> axes = {};
  std::vector<std::string> variants = {};  ///< Names; none without variants.
  std::vector<SweepCriterion> criteria = {};
  std::optional<StopWhen> stop_when = {};
  std::optional<SearchedBoundary> sought = {};

  std::vector<std::string> keys() const;
  /// One of no name without variants.
  std::vector<std::string> flown_variants() const;
};

SweepSpec TermsOf(const SweepFile& file);

std::string TermsJson(const SweepSpec& terms);
/// Throws InputError, without a file name, for a text that TermsJson did not write.
SweepSpec TermsFromJson(const std::string& text);

}  // namespace touchdown::sweeper
