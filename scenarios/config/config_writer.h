#pragma once

#include "scenarios/config/config_visitor.h"

namespace touchdown::config {

/// The shortest decimal number that, read in `unit`, gives `value_si` again to the last bit. Where no number does (not
/// every SI value is a number of degrees), one whose reading is within an ulp or two.
std::string WriteNumber(double value_si, const Unit& unit);

/// `text` as a quoted YAML scalar.
std::string WriteText(const std::string& text);

/// Writes every field it visits as YAML, but no section without fields.
class ConfigWriter : public ConfigVisitor {
 public:
  const std::string& yaml() const { return yaml_; }

  void Number(const Key& key, double& value_si, const Unit& unit, const Range& range) override;
  void OptionalNumber(const Key& key, std::optional<double>& value_si, const Unit& unit, const Range& range) override;
  void Numbers(const Key& key, const std::vector<double*>& values_si, const Unit& unit, const Range& range) override;
  void Integer64(const Key& key, std::int64_t& value, const Range& range) override;
  void Boolean(const Key& key, bool& value) override;
  void Text(const Key& key, std::string& value) override;
  void Choice(const Key& key, int& index, std::span<const std::string_view> names) override;
  void Section(const Key& key, const SectionFile& file, const std::function<void(ConfigVisitor&)>& describe) override;
  void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(ConfigVisitor&, std::size_t)>& describe) override;
  void Check(std::string_view, const std::function<void()>&) override {}

 private:
  void Line(const Key& key, std::string_view value);

  std::string yaml_;
  int depth_ = 0;
  bool begins_item_ = false;  ///< The next line is the first of a list's item.
};

}  // namespace touchdown::config
