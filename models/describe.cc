#include "models/describe.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace touchdown::models {
namespace {

/// Shortest decimal number that parses to the same bits. Numbers of usual size have no exponent.
std::string NumberText(double value) {
  constexpr double kSmallest = 1e-4, kLargest = 1e16;
  const double size = std::abs(value);
  const bool is_plain = size == 0.0 || (size >= kSmallest && size < kLargest) || !std::isfinite(value);
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          is_plain ? std::chars_format::fixed : std::chars_format::scientific);
  return {text.data(), end};
}

}  // namespace

std::string Range::Sentence() const {
  if (min == max) return "must be " + NumberText(min);
  const bool has_min = std::isfinite(min), has_max = std::isfinite(max);
  if (has_min && has_max && !min_is_open) return "must be from " + NumberText(min) + " to " + NumberText(max);
  std::string sentence = "must be ";
  if (has_min) sentence += (min_is_open ? "above " : "at least ") + NumberText(min);
  if (has_min && has_max) sentence += " and ";
  if (has_max) sentence += "at most " + NumberText(max);
  return sentence;
}

std::string ConfigChecker::PathOf(std::string_view key) const {
  const bool joins = !path_.empty() && !key.empty();
  return path_ + (joins ? "." : "") + std::string(key);
}

InputError ConfigChecker::Error(const std::string& path, const std::string& message) const {
  return InputError(path.empty() ? message : path + ": " + message);
}

void ConfigChecker::CheckNumber(const std::string& path, double value, const Range& range) const {
  if (!std::isfinite(value)) throw Error(path, "must be a finite number, is " + NumberText(value));
  if (!range.Contains(value)) throw Error(path, range.Sentence() + ", is " + NumberText(value));
}

void ConfigChecker::Number(const Key& key, double& value, const Unit&, const Range& range) {
  CheckNumber(PathOf(key.name), value, range);
}

void ConfigChecker::OptionalNumber(const Key& key, std::optional<double>& value, const Unit&, const Range& range) {
  if (value) CheckNumber(PathOf(key.name), *value, range);
}

void ConfigChecker::Numbers(const Key& key, const std::vector<double*>& values, const Unit&, const Range& range) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    CheckNumber(PathOf(key.name) + "." + std::to_string(i), *values[i], range);
  }
}

void ConfigChecker::Integer64(const Key& key, std::int64_t& value, const Range& range) {
  CheckNumber(PathOf(key.name), static_cast<double>(value), range);
}

void ConfigChecker::Choice(const Key& key, int& index, std::span<const std::string_view> names) {
  if (index >= static_cast<int>(names.size())) throw Error(PathOf(key.name), "is not one of the choices");
}

void ConfigChecker::Section(const Key& key, const SectionFile&, const std::function<void(ConfigVisitor&)>& describe) {
  const std::string parent = std::exchange(path_, PathOf(key.name));
  describe(*this);
  path_ = parent;
}

void ConfigChecker::List(const Key& key, std::size_t count, const std::function<void(std::size_t)>&,
                         const std::function<void(ConfigVisitor&, std::size_t)>& describe) {
  const std::string parent = path_, list = PathOf(key.name);
  for (std::size_t i = 0; i < count; ++i) {
    path_ = list + "." + std::to_string(i);
    describe(*this, i);
  }
  path_ = parent;
}

void ConfigChecker::Check(std::string_view key, const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw Error(PathOf(key), error.what());
  }
}

}  // namespace touchdown::models
