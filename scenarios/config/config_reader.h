#pragma once

#include <deque>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include "models/describe.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// Origins of the sections and keys in the configuration, by path ("camera.model").
using OriginByPath = std::map<std::string, Origin, std::less<>>;

/// Sets the fields whose keys a node contains; other fields keep their values. Every member throws InputError with
/// place and key for a value that has the wrong type, is not finite or is out of range, and for a missing required key.
class ConfigReader : public models::ConfigVisitor {
 public:
  /// `origins` receives the origin of every key that was read.
  ConfigReader(const ConfigNode& root, OriginByPath& origins);

  /// Accepts keys of the root without reading them, because other code does.
  void LeaveAlone(std::span<const std::string_view> keys) { open_.back().visited.insert(keys.begin(), keys.end()); }

  /// Throws InputError if the root contains a key that was not visited. Call it last.
  void Finish() { LeaveKeys(); }

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
  void Renamed(std::string_view old_key, std::string_view new_key) override;
  void Check(std::string_view, const std::function<void()>&) override {}

 private:
  struct Open {
    const ConfigNode* node;  ///< Null for a section that is absent.
    std::string path;
    std::set<std::string, std::less<>> visited;
  };

  const ConfigNode* Visit(const models::Key& key);
  /// Node of a key, which must be a scalar; nullptr if the key is absent.
  const ConfigNode* VisitText(const models::Key& key, std::string_view what);
  std::string PathOf(std::string_view key) const;
  void EnterKeys(const ConfigNode* node, const std::string& path);
  void LeaveKeys();
  void PatchItems(const ConfigNode& node, const std::string& path, std::size_t count,
                  const std::function<void(models::ConfigVisitor&, std::size_t)>& describe);

  OriginByPath& origins_;
  std::vector<Open> open_;
  std::deque<ConfigNode> files_;  ///< Roots of the files that sections refer to.
};

/// Checks a configuration after reading. Throws InputError with the origin of the key or of the section that contains
/// it.
class OriginChecker : public models::ConfigChecker {
 public:
  /// `fallback` is the origin of absent keys in absent sections.
  OriginChecker(const OriginByPath& origins, Origin fallback) : origins_(origins), fallback_(std::move(fallback)) {}

 protected:
  InputError Error(const std::string& path, const std::string& message) const override;

 private:
  /// Origin of the innermost part of `path` that is present.
  const Origin& OriginOf(std::string_view path) const;

  const OriginByPath& origins_;
  Origin fallback_;
};

/// Reads a struct from the keys of `root` and checks it. Skips the keys `read_elsewhere`. Throws InputError with place
/// and key.
template <typename T>
T ReadAlone(const ConfigNode& root, std::span<const std::string_view> read_elsewhere = {}) {
  T value;
  OriginByPath origins;
  ConfigReader reader(root, origins);
  reader.LeaveAlone(read_elsewhere);
  Describe(reader, value);
  reader.Finish();
  OriginChecker checker(origins, root.origin);
  Describe(checker, value);
  return value;
}

}  // namespace touchdown::config
