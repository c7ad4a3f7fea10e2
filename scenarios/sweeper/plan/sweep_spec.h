#pragma once

#include <string>
#include <vector>

#include "scenarios/sweeper/plan/sweep_file.h"

namespace touchdown::sweeper {

/// A parameter of a sweep, which is an axis of its results.
struct SweepAxis {
  std::string key = {};
  std::vector<std::string> listed = {};  ///< Listed values as YAML; empty for drawn values.
};

/// Specification of a sweep: its axes, limits and criteria. It is stored with the rows, to report and judge them.
struct SweepSpec {
  std::string name = {};
  std::string description = {};
  std::vector<SweepAxis> axes = {};
  std::vector<std::string> variants = {};  ///< Names of the variants; empty without variants.
  std::vector<SweepCriterion> criteria = {};
  std::optional<StopWhen> stop_when = {};
  std::optional<SearchedBoundary> search = {};

  /// Keys of the axes.
  std::vector<std::string> keys() const;
  /// Names of the variants; one empty name for a sweep without variants.
  std::vector<std::string> flown_variants() const;
};

/// Specification of a sweep file.
SweepSpec SpecOf(const SweepFile& file);

/// Specification as JSON, for the database.
std::string SpecJson(const SweepSpec& spec);
/// Parses the output of SpecJson. Throws InputError, without a file name, for other text.
SweepSpec SpecFromJson(const std::string& text);

}  // namespace touchdown::sweeper
