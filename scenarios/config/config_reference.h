#pragma once

#include <string>
#include <vector>

#include "models/describe.h"

namespace touchdown::config {

/// Reference row of a configuration key.
struct KeyRow {
  std::string path;           ///< "camera.model.k1"; "events.N.at_s" for items of lists.
  std::string unit;           ///< "-" for none.
  std::string default_value;  ///< In YAML.
  std::string range;          ///< "must be above 0"; empty without limits.
  std::string doc;
};

/// Lists all visited keys with the defaults of their structs. Which keys are visited depends on the values of choices
/// and booleans; the variant selects these values. The rows of all variants are merged into one reference.
class ConfigReference : public models::ConfigVisitor {
 public:
  const std::vector<KeyRow>& rows() const { return rows_; }

  /// Selects the values of choices and booleans. Call before each visit of the description.
  void BeginVariant(int variant);

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
  void OptionalSection(const models::Key& key, bool is_set, const models::SectionFile& file,
                       const std::function<void(models::ConfigVisitor&)>& describe) override;
  void List(const models::Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(models::ConfigVisitor&, std::size_t)>& describe) override;
  void Check(std::string_view, const std::function<void()>&) override {}

 private:
  void Row(const models::Key& key, std::string_view unit, const std::string& default_value, const std::string& range);

  std::vector<KeyRow> rows_;
  std::size_t next_ = 0;  ///< Position of the next new row.
  std::string path_;
  bool is_optional_ = false;  ///< Within an optional section, whose keys have no defaults.
  int variant_ = 0;
};

}  // namespace touchdown::config
