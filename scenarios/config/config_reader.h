#pragma once

#include <deque>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include "scenarios/config/config_visitor.h"

namespace touchdown::config {

/// Where each section and key that somebody wrote was written, by its path ("camera.model").
using OriginByPath = std::map<std::string, Origin, std::less<>>;

/// Sets the fields that a node gives and leaves the others as they are. Every member throws InputError, naming place
/// and key, for a value of the wrong type, not finite or out of range, and for a required key that is absent.
class ConfigReader : public ConfigVisitor {
 public:
  /// `origins` takes the place of all that was read.
  ConfigReader(const ConfigNode& root, OriginByPath& origins);

  /// Keys of the root that are read by somebody else.
  void LeaveAlone(std::span<const std::string_view> keys) { open_.back().visited.insert(keys.begin(), keys.end()); }

  /// Throws InputError when the root holds a key that was not visited. Call it last.
  void Finish() { LeaveKeys(); }

  void Number(const Key& key, double& value_si, const Unit& unit, const Range& range) override;
  void OptionalNumber(const Key& key, std::optional<double>& value_si, const Unit& unit, const Range& range) override;
  void Numbers(const Key& key, const std::vector<double*>& values_si, const Unit& unit, const Range& range) override;
  void Integer64(const Key& key, std::int64_t& value, const Range& range) override;
  void Boolean(const Key& key, bool& value) override;
  void Text(const Key& key, std::string& value) override;
  void Choice(const Key& key, int& index, std::span<const std::string_view> names) override;
  void Section(const Key& key, const SectionFile& file, const std::function<void(ConfigVisitor&)>& describe) override;
  void OptionalSection(const Key& key, bool is_set, const SectionFile& file,
                       const std::function<void(ConfigVisitor&)>& describe) override;
  void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(ConfigVisitor&, std::size_t)>& describe) override;
  void Renamed(std::string_view old_key, std::string_view new_key) override;
  void Check(std::string_view, const std::function<void()>&) override {}

 private:
  struct Open {
    const ConfigNode* node;  ///< Null in a section that is not written.
    std::string path;
    std::set<std::string, std::less<>> visited;
  };

  const ConfigNode* Visit(const Key& key);
  /// The node of a visited key, which must be text, or nullptr when absent.
  const ConfigNode* VisitText(const Key& key, std::string_view what);
  std::string PathOf(std::string_view key) const;
  void EnterKeys(const ConfigNode* node, const std::string& path);
  void LeaveKeys();
  void PatchItems(const ConfigNode& node, const std::string& path, std::size_t count,
                  const std::function<void(ConfigVisitor&, std::size_t)>& describe);

  OriginByPath& origins_;
  std::vector<Open> open_;
  std::deque<ConfigNode> files_;  ///< The roots of files that sections named.
};

/// Runs the checks of a configuration that has been read. Its visits throw InputError with the place of the section.
class ConfigChecker : public ConfigVisitor {
 public:
  /// `fallback` is named for what nobody wrote, nor anything around it.
  ConfigChecker(const OriginByPath& origins, Origin fallback) : origins_(origins), fallback_(std::move(fallback)) {}

  void Number(const Key&, double&, const Unit&, const Range&) override {}
  void OptionalNumber(const Key&, std::optional<double>&, const Unit&, const Range&) override {}
  void Numbers(const Key&, const std::vector<double*>&, const Unit&, const Range&) override {}
  void Integer64(const Key&, std::int64_t&, const Range&) override {}
  void Boolean(const Key&, bool&) override {}
  void Text(const Key&, std::string&) override {}
  void Choice(const Key&, int&, std::span<const std::string_view>) override {}
  void Section(const Key& key, const SectionFile& file, const std::function<void(ConfigVisitor&)>& describe) override;
  void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(ConfigVisitor&, std::size_t)>& describe) override;
  void Check(std::string_view key, const std::function<void()>& check) override;

 private:
  std::string PathOf(std::string_view key) const;
  /// Of the innermost part of `path` that somebody wrote.
  const Origin& OriginOf(std::string_view path) const;

  const OriginByPath& origins_;
  Origin fallback_;
  std::string path_;
};

/// Reads and checks a struct whose keys are those of `root`, but for some that are read elsewhere. Throws InputError,
/// naming place and key.
template <typename T>
T ReadAlone(const ConfigNode& root, std::span<const std::string_view> read_elsewhere = {}) {
  T value;
  OriginByPath origins;
  ConfigReader reader(root, origins);
  reader.LeaveAlone(read_elsewhere);
  Describe(reader, value);
  reader.Finish();
  ConfigChecker checker(origins, root.origin);
  Describe(checker, value);
  return value;
}

}  // namespace touchdown::config
