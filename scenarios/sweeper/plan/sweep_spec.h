#pragma once

#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// Parameter of a sweep, an axis of its results.
struct SweepAxis {
  std::string key = {};
  std::vector<std::string> listed = {};  ///< Listed values, YAML; empty for drawn values.
};

/// Axes, limits and criteria of a sweep, by which its results are reported and judged. They are stored beside its rows.
struct SweepSpec {
  std::string name = {};
  std::string description = {};
  std::vector<SweepAxis> axes = {};
  std::vector<std::string> variants = {};  ///< Names; empty without variants.
  std::vector<SweepCriterion> criteria = {};
  std::optional<StopWhen> stop_when = {};
  std::optional<SearchedBoundary> search = {};

  std::vector<std::string> keys() const;
  /// One unnamed variant for a sweep without variants.
  std::vector<std::string> flown_variants() const;
};

SweepSpec TermsOf(const SweepFile& file);

std::string TermsJson(const SweepSpec& terms);
/// Throws InputError, without a file name, for text that TermsJson did not write.
SweepSpec TermsFromJson(const std::string& text);

}  // namespace touchdown::sweeper
