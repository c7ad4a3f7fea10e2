#include "scenarios/config/config_writer.h"

#include <fmt/format.h>

namespace touchdown::config {

std::string WriteNumber(double value) { return fmt::format("{}", value); }

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

void ConfigWriter::Line(const models::Key& key, std::string_view value) {
  const int indent = 2 * depth_;
  yaml_ += begins_item_ ? std::string(static_cast<std::size_t>(indent - 2), ' ') + "- "
                        : std::string(static_cast<std::size_t>(indent), ' ');
  begins_item_ = false;
  yaml_ += fmt::format("{}:{}{}\n", key.name, value.empty() ? "" : " ", value);
}

void ConfigWriter::Number(const models::Key& key, double& value, const models::Unit&, const models::Range&) {
  Line(key, WriteNumber(value));
}

void ConfigWriter::OptionalNumber(const models::Key& key, std::optional<double>& value, const models::Unit&,
                                  const models::Range&) {
  if (value) Line(key, WriteNumber(*value));
}

void ConfigWriter::Numbers(const models::Key& key, const std::vector<double*>& values, const models::Unit&,
                           const models::Range&) {
  std::string list;
  for (const double* value : values) list += (list.empty() ? "" : ", ") + WriteNumber(*value);
  Line(key, "[" + list + "]");
}

void ConfigWriter::Integer64(const models::Key& key, std::int64_t& value, const models::Range&) {
  Line(key, fmt::format("{}", value));
}

void ConfigWriter::Boolean(const models::Key& key, bool& value) { Line(key, value ? "true" : "false"); }

void ConfigWriter::Text(const models::Key& key, std::string& value) { Line(key, WriteText(value)); }

void ConfigWriter::Choice(const models::Key& key, int& index, std::span<const std::string_view> names) {
  if (index >= 0) Line(key, names[static_cast<std::size_t>(index)]);
}

void ConfigWriter::Section(const models::Key& key, const models::SectionFile&,
                           const std::function<void(models::ConfigVisitor&)>& describe) {
  const std::size_t before = yaml_.size();
  Line(key, "");
  const std::size_t after = yaml_.size();
  ++depth_;
  describe(*this);
  --depth_;
  if (yaml_.size() == after) yaml_.resize(before);
}

void ConfigWriter::List(const models::Key& key, std::size_t count, const std::function<void(std::size_t)>&,
                        const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) {
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
