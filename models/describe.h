#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "models/error.h"

/// Description of configurations. The keys of a struct are described once, next to the struct, by a function
///
///     void Describe(models::ConfigVisitor& v, CameraConfig& config);
///
/// in the struct's namespace. It visits every key with its name, meaning, unit, range and field; the default is the
/// field's initializer. Reading, writing, checking and documenting are visitors.
namespace touchdown::models {

/// The unit in which a key's number is written and stored; "-" for none.
struct Unit {
  std::string_view name;
};

inline constexpr Unit kNoUnit{"-"}, kMeter{"m"}, kSecond{"s"}, kMillisecond{"ms"}, kKilogram{"kg"}, kNewton{"N"},
    kMeterPerSecond{"m/s"}, kMeterPerSecond2{"m/s^2"}, kRadianPerSecond{"rad/s"}, kRadianPerSecond2{"rad/s^2"},
    kPixel{"px"}, kHertz{"Hz"}, kPerSecond{"1/s"}, kPerSecond2{"1/s^2"}, kMeterPerSecond2RootHertz{"m/s^2/sqrt(Hz)"},
    kRadianPerSecondRootHertz{"rad/s/sqrt(Hz)"}, kDegree{"deg"}, kDegreePerSecond{"deg/s"};

/// Numbers that a key accepts, in the key's unit.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_is_open = false;  ///< `min` itself is out of range.

  bool Contains(double value) const { return (min_is_open ? value > min : value >= min) && value <= max; }
  /// The range as a requirement, for example "must be above 0 and at most 3".
  std::string Sentence() const;
};

inline constexpr Range kAny{}, kPositive{.min = 0.0, .min_is_open = true}, kNotNegative{.min = 0.0},
    kFraction{.min = 0.0, .max = 1.0};
constexpr Range Between(double min, double max) { return {.min = min, .max = max}; }
constexpr Range PositiveUpTo(double max) { return {.min = 0.0, .max = max, .min_is_open = true}; }

/// Longest time that a key accepts, s: ten hours, longer than any flight.
inline constexpr double kLongest_s = 36000.0;
inline constexpr Range kPositiveTime = PositiveUpTo(kLongest_s), kTime = Between(0.0, kLongest_s);

/// Name and description of a key. The reference of keys lists both.
struct Key {
  std::string_view name;
  std::string_view doc;
  bool required = false;  ///< The key must be given; for keys of list items and of the root.
};

/// Whether a section's value may be the name of a file that holds the section's keys.
struct SectionFile {
  bool allowed = false;
  /// Name of another format that the file may have ("camera_info"). Readers identify formats by these names.
  std::string_view format = {};
  /// The key of the section that such a file describes; empty for the section itself.
  std::string_view format_key = {};
};
inline constexpr SectionFile kOrFile{.allowed = true};

/// Visits every key of a configuration, in the order of its description. A visitor that reads sets a field as it is
/// visited, so a description may depend on earlier fields.
class ConfigVisitor {
 public:
  virtual ~ConfigVisitor() = default;

  virtual void Number(const Key& key, double& value, const Unit& unit, const Range& range) = 0;
  virtual void OptionalNumber(const Key& key, std::optional<double>& value, const Unit& unit, const Range& range) = 0;
  /// A list of exactly `values.size()` numbers.
  virtual void Numbers(const Key& key, const std::vector<double*>& values, const Unit& unit, const Range& range) = 0;
  virtual void Integer64(const Key& key, std::int64_t& value, const Range& range) = 0;
  virtual void Boolean(const Key& key, bool& value) = 0;
  virtual void Text(const Key& key, std::string& value) = 0;
  /// One of `names`; `index` is the index of the chosen name, -1 if none is given.
  virtual void Choice(const Key& key, int& index, std::span<const std::string_view> names) = 0;

  /// A section: keys nested in a key.
  virtual void Section(const Key& key, const SectionFile& file,
                       const std::function<void(ConfigVisitor&)>& describe) = 0;
  /// A section that may be absent; `is_set` is true when it is present. By default, visitors visit only sections that
  /// are present.
  virtual void OptionalSection(const Key& key, bool is_set, const SectionFile& file,
                               const std::function<void(ConfigVisitor&)>& describe) {
    if (is_set) Section(key, file, describe);
  }
  /// A list of sections. `resize` is called with the count of items before they are described.
  virtual void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
                    const std::function<void(ConfigVisitor&, std::size_t)>& describe) = 0;

  /// A renamed key of the visited section. `new_key` is the new name, relative to the section. A file that still uses
  /// `old_key` is an error, and the message states the new name.
  virtual void Renamed(std::string_view /*old_key*/, std::string_view /*new_key*/) {}

  /// A condition that spans several keys, reported at a key of the visited section, or at the section itself if `key`
  /// is "". It is checked after everything is read: `check` throws InputError, without a location.
  virtual void Check(std::string_view key, const std::function<void()>& check) = 0;

  template <std::integral T>
  void Integer(const Key& key, T& value, const Range& range) {
    std::int64_t wide = static_cast<std::int64_t>(value);
    Range fitting = range;
    if constexpr (sizeof(T) < sizeof wide) {
      fitting.max = std::min(range.max, static_cast<double>(std::numeric_limits<T>::max()));
    }
    Integer64(key, wide, fitting);
    value = static_cast<T>(wide);
  }

  template <typename Enum>
  void Choice(const Key& key, Enum& value, std::span<const std::string_view> names) requires std::is_enum_v<Enum> {
    int index = static_cast<int>(value);
    Choice(key, index, names);
    value = static_cast<Enum>(index);
  }

  template <typename Vector>
  void Vector3(const Key& key, Vector& v, const Unit& unit, const Range& range) {
    Numbers(key, {&v.x(), &v.y(), &v.z()}, unit, range);
  }

  template <typename T>
  void Items(const Key& key, std::vector<T>& items) {
    List(
        key, items.size(), [&items](std::size_t count) { items.assign(count, T()); },
        [&items](ConfigVisitor& v, std::size_t index) { Describe(v, items[index]); });
  }

  template <typename T>
  void Keys(const Key& key, T& section, const SectionFile& file = {}) {
    Section(key, file, [&section](ConfigVisitor& v) { Describe(v, section); });
  }

  /// An optional section. When it is present, the keys that it omits have the values of `defaults`.
  template <typename T>
  void OptionalKeys(const Key& key, std::optional<T>& section, const T& defaults, const SectionFile& file = {}) {
    OptionalSection(key, section.has_value(), file, [&section, &defaults](ConfigVisitor& v) {
      if (!section) section = defaults;
      Describe(v, *section);
    });
  }
};

/// Throws InputError for the first value that is not finite or outside its key's range, and for the first check that
/// fails. Changes nothing.
class ConfigChecker : public ConfigVisitor {
 public:
  void Number(const Key& key, double& value, const Unit& unit, const Range& range) override;
  void OptionalNumber(const Key& key, std::optional<double>& value, const Unit& unit, const Range& range) override;
  void Numbers(const Key& key, const std::vector<double*>& values, const Unit& unit, const Range& range) override;
  void Integer64(const Key& key, std::int64_t& value, const Range& range) override;
  void Boolean(const Key&, bool&) override {}
  void Text(const Key&, std::string&) override {}
  void Choice(const Key& key, int& index, std::span<const std::string_view> names) override;
  void Section(const Key& key, const SectionFile& file, const std::function<void(ConfigVisitor&)>& describe) override;
  void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
            const std::function<void(ConfigVisitor&, std::size_t)>& describe) override;
  void Check(std::string_view key, const std::function<void()>& check) override;

 protected:
  /// Error at a key, given by its path from the described struct ("rotor.max_speed_rad_s"); "" is the struct itself.
  virtual InputError Error(const std::string& path, const std::string& message) const;

 private:
  std::string PathOf(std::string_view key) const;
  void CheckNumber(const std::string& path, double value, const Range& range) const;

  std::string path_;
};

/// Throws InputError, without a place, for a value outside the range of its key and for a check of the description that
/// fails.
template <typename T>
void ValidateConfig(T config) {
  ConfigChecker checker;
  Describe(checker, config);
}

}  // namespace touchdown::models
