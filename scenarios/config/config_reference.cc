#include "scenarios/config/config_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/config/config_writer.h"

namespace touchdown::config {
namespace {

/// Unit of an integer key, from the suffix of its name.
std::string_view UnitOfInteger(std::string_view name) {
  if (name.ends_with("_hz")) return "Hz";
  return name.ends_with("_px") ? "px" : "-";
}

std::string RangeText(const models::Range& range) {
  return std::isfinite(range.min) || std::isfinite(range.max) ? range.Sentence() : "";
}

}  // namespace

void ConfigReference::BeginVariant(int variant) {
  variant_ = variant;
  next_ = 0;
}

void ConfigReference::Row(const models::Key& key, std::string_view unit, const std::string& default_value,
                          const std::string& range) {
  const std::string path = path_ + std::string(key.name);
  const auto known = std::find_if(rows_.begin(), rows_.end(), [&path](const auto& row) { return row.path == path; });
  if (known != rows_.end()) {
    next_ = static_cast<std::size_t>(known - rows_.begin()) + 1;
    return;
  }
  const std::string displayed_default = key.required ? "required" : is_optional_ ? "none" : default_value;
  rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(next_),
               {path, std::string(unit), displayed_default, range, std::string(key.doc)});
  ++next_;
}

void ConfigReference::Number(const models::Key& key, double& value, const models::Unit& unit,
                             const models::Range& range) {
  Row(key, unit.name, WriteNumber(value), RangeText(range));
}

void ConfigReference::OptionalNumber(const models::Key& key, std::optional<double>&, const models::Unit& unit,
                                     const models::Range& range) {
  Row(key, unit.name, "none", RangeText(range));
}

void ConfigReference::Numbers(const models::Key& key, const std::vector<double*>& values, const models::Unit& unit,
                              const models::Range& range) {
  std::vector<std::string> numbers;
  for (const double* value : values) numbers.push_back(WriteNumber(*value));
  Row(key, unit.name, fmt::format("[{}]", fmt::join(numbers, ", ")), RangeText(range));
}

void ConfigReference::Integer64(const models::Key& key, std::int64_t& value, const models::Range& range) {
  Row(key, UnitOfInteger(key.name), fmt::format("{}", value), RangeText(range));
}

void ConfigReference::Boolean(const models::Key& key, bool& value) {
  Row(key, "-", value ? "true" : "false", "must be true or false");
  value = variant_ % 2 != 0;
}

void ConfigReference::Text(const models::Key& key, std::string& value) {
  Row(key, "-", value.empty() ? "" : WriteText(value), "");
}

void ConfigReference::Choice(const models::Key& key, int& index, std::span<const std::string_view> names) {
  Row(key, "-", index < 0 ? "none" : std::string(names[static_cast<std::size_t>(index)]),
      fmt::format("must be one of {}", fmt::join(names, ", ")));
  index = variant_ % static_cast<int>(names.size());
}

void ConfigReference::Section(const models::Key& key, const models::SectionFile& file,
                              const std::function<void(models::ConfigVisitor&)>& describe) {
  Row(key, "-", file.allowed ? "keys or file name" : "keys", "");
  const std::string parent = path_;
  path_ += std::string(key.name) + ".";
  describe(*this);
  path_ = parent;
}

void ConfigReference::OptionalSection(const models::Key& key, bool /*is_set*/, const models::SectionFile& file,
                                      const std::function<void(models::ConfigVisitor&)>& describe) {
  const bool outer = std::exchange(is_optional_, true);
  Section(key, file, describe);
  is_optional_ = outer;
}

void ConfigReference::List(const models::Key& key, std::size_t, const std::function<void(std::size_t)>& resize,
                           const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) {
  Row(key, "-", "[]", "");
  resize(1);
  const std::string parent = path_;
  path_ += std::string(key.name) + ".N.";
  describe(*this, 0);
  path_ = parent;
}

}  // namespace touchdown::config
