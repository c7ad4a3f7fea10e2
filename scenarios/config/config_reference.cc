#include "scenarios/config/config_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/config/config_writer.h"

namespace touchdown::config {
namespace {

/// Short enough to read; the exact number may be longer, as many SI values in degrees are.
std::string ShortNumber(double value_si, const Unit& unit) {
  return fmt::format("{:.6g}", value_si * unit.divisor / unit.scale);
}

/// Integers carry their unit in their name alone.
std::string_view UnitOfInteger(std::string_view name) {
  if (name.ends_with("_hz")) return "Hz";
  return name.ends_with("_px") ? "px" : "-";
}

std::string RangeText(const Range& range) {
  return std::isfinite(range.min) || std::isfinite(range.max) ? range.Describe() : "";
}

}  // namespace

void ConfigReference::BeginVariant(int variant) {
  variant_ = variant;
  next_ = 0;
}

void ConfigReference::Row(const Key& key, std::string_view unit, const std::string& default_value,
                          const std::string& range) {
  const std::string path = path_ + std::string(key.name);
  const auto known = std::find_if(rows_.begin(), rows_.end(), [&path](const auto& row) { return row.path == path; });
  if (known != rows_.end()) {
    next_ = static_cast<std::size_t>(known - rows_.begin()) + 1;
    return;
  }
  const std::string shown = key.required ? "required" : is_optional_ ? "none" : default_value;
  rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(next_),
               {path, std::string(unit), shown, range, std::string(key.doc)});
  ++next_;
}

void ConfigReference::Number(const Key& key, double& value_si, const Unit& unit, const Range& range) {
  Row(key, unit.name, ShortNumber(value_si, unit), RangeText(range));
}

void ConfigReference::OptionalNumber(const Key& key, std::optional<double>&, const Unit& unit, const Range& range) {
  Row(key, unit.name, "none", RangeText(range));
}

void ConfigReference::Numbers(const Key& key, const std::vector<double*>& values_si, const Unit& unit,
                              const Range& range) {
  std::vector<std::string> numbers;
  for (const double* value : values_si) numbers.push_back(ShortNumber(*value, unit));
  Row(key, unit.name, fmt::format("[{}]", fmt::join(numbers, ", ")), RangeText(range));
}

void ConfigReference::Integer64(const Key& key, std::int64_t& value, const Range& range) {
  Row(key, UnitOfInteger(key.name), fmt::format("{}", value), RangeText(range));
}

void ConfigReference::Boolean(const Key& key, bool& value) {
  Row(key, "-", value ? "true" : "false", "must be true or false");
  value = variant_ % 2 != 0;
}

void ConfigReference::Text(const Key& key, std::string& value) {
  Row(key, "-", value.empty() ? "" : WriteText(value), "");
}

void ConfigReference::Choice(const Key& key, int& index, std::span<const std::string_view> names) {
  Row(key, "-", index < 0 ? "none" : std::string(names[static_cast<std::size_t>(index)]),
      fmt::format("must be one of {}", fmt::join(names, ", ")));
  index = variant_ % static_cast<int>(names.size());
}

void ConfigReference::Section(const Key& key, const SectionFile& file,
                              const std::function<void(ConfigVisitor&)>& describe) {
  Row(key, "-", file.allowed ? "keys, or a file" : "keys", "");
  const std::string parent = path_;
  path_ += std::string(key.name) + ".";
  describe(*this);
  path_ = parent;
}

void ConfigReference::OptionalSection(const Key& key, bool /*is_set*/, const SectionFile& file,
                                      const std::function<void(ConfigVisitor&)>& describe) {
  const bool around = std::exchange(is_optional_, true);
  Section(key, file, describe);
  is_optional_ = around;
}

void ConfigReference::List(const Key& key, std::size_t, const std::function<void(std::size_t)>& resize,
                           const std::function<void(ConfigVisitor&, std::size_t)>& describe) {
  Row(key, "-", "[]", "");
  resize(1);
  const std::string parent = path_;
  path_ += std::string(key.name) + ".N.";
  describe(*this, 0);
  path_ = parent;
}

}  // namespace touchdown::config
