#pragma once

#include "models/describe.h"

namespace touchdown::config {

/// Decimal number with the fewest digits that reads back to the same double.
std::string WriteNumber(double value);

/// `text` as a quoted YAML scalar.
std::string WriteText(const std::string& text);

/// Writes all visited fields as YAML. Omits empty sections.
class ConfigWriter : public models::ConfigVisitor {
 public:
  const std::string& yaml() const { return yaml_; }

  void Number(const models::Key& key, double& value, const models::Unit& unit, const models::Range& range) override;
  void OptionalNumber(const models::Key& key, std::optional<double>& value, const models::Unit& unit,
                      const models::Range& range) override;
  void Numbers(const models::Key& key, const std::vector<double*>& values, const models::Unit& unit,
               const models::Range& range) override;
  void Integer64(const models::Key& key, std::int64_t& value, const models::Range& range) override;
  void Boolean(const models::Key& key, bool& value) override;
  void Text(const models::Key& key, std::string& value) override;
  void Choice(const models::Key& key, int& index, std::span<const std::string_view> names) override;
  void Section(const models::Key& key, const models::SectionFile& file,
               const std::function<void(models::ConfigVisitor&)>& describe) override;
  void List(const models::Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) override;
  void Check(std::string_view, const std::function<void()>&) override {}

 private:
  void Line(const models::Key& key, std::string_view value);

  std::string yaml_;
  int depth_ = 0;
  bool begins_item_ = false;  ///< The next line is the first of a list item.
};

}  // namespace touchdown::config
