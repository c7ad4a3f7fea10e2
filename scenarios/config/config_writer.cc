#include "scenarios/config/config_writer.h"

#include <fmt/format.h>

#include <cmath>

namespace touchdown::config {

std::string WriteNumber(double value_si, const Unit& unit) {
  const double nearest = value_si * unit.divisor / unit.scale;
  const bool is_si = unit.scale == 1.0 && unit.divisor == 1.0;
  if (is_si || value_si == 0.0) return fmt::format("{}", value_si);
  std::string shortest;
  constexpr int kNeighbours = 4;
  double candidate = nearest;
  for (int i = 0; i < kNeighbours; ++i) candidate = std::nextafter(candidate, -HUGE_VAL);
  for (int i = -kNeighbours; i <= kNeighbours; ++i, candidate = std::nextafter(candidate, HUGE_VAL)) {
    if (unit.ToSi(candidate) != value_si) continue;
    const std::string text = fmt::format("{}", candidate);
    if (shortest.empty() || text.size() < shortest.size()) shortest = text;
  }
  return shortest.empty() ? fmt::format("{}", nearest) : shortest;
}

std::string WriteText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\x{:02x}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

void ConfigWriter::Line(const Key& key, std::string_view value) {
  const int indent = 2 * depth_;
  yaml_ += begins_item_ ? std::string(static_cast<std::size_t>(indent - 2), ' ') + "- "
                        : std::string(static_cast<std::size_t>(indent), ' ');
  begins_item_ = false;
  yaml_ += fmt::format("{}:{}{}\n", key.name, value.empty() ? "" : " ", value);
}

void ConfigWriter::Number(const Key& key, double& value_si, const Unit& unit, const Range&) {
  Line(key, WriteNumber(value_si, unit));
}

void ConfigWriter::OptionalNumber(const Key& key, std::optional<double>& value_si, const Unit& unit, const Range&) {
  if (value_si) Line(key, WriteNumber(*value_si, unit));
}

void ConfigWriter::Numbers(const Key& key, const std::vector<double*>& values_si, const Unit& unit, const Range&) {
  std::string list;
  for (const double* value : values_si) list += (list.empty() ? "" : ", ") + WriteNumber(*value, unit);
  Line(key, "[" + list + "]");
}

void ConfigWriter::Integer64(const Key& key, std::int64_t& value, const Range&) { Line(key, fmt::format("{}", value)); }

void ConfigWriter::Boolean(const Key& key, bool& value) { Line(key, value ? "true" : "false"); }

void ConfigWriter::Text(const Key& key, std::string& value) { Line(key, WriteText(value)); }

void ConfigWriter::Choice(const Key& key, int& index, std::span<const std::string_view> names) {
  if (index >= 0) Line(key, names[static_cast<std::size_t>(index)]);
}

void ConfigWriter::Section(const Key& key, const SectionFile&, const std::function<void(ConfigVisitor&)>& describe) {
  const std::size_t before = yaml_.size();
  Line(key, "");
  const std::size_t after = yaml_.size();
  ++depth_;
  describe(*this);
  --depth_;
  if (yaml_.size() == after) yaml_.resize(before);
}

void ConfigWriter::List(const Key& key, std::size_t count, const std::function<void(std::size_t)>&,
                        const std::function<void(ConfigVisitor&, std::size_t)>& describe) {
  if (count == 0) {
    Line(key, "[]");
    return;
  }
  Line(key, "");
  depth_ += 2;
  for (std::size_t i = 0; i < count; ++i) {
    begins_item_ = true;
    describe(*this, i);
  }
  depth_ -= 2;
}

}  // namespace touchdown::config
