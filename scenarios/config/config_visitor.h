#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/angles.h"
#include "scenarios/config/config_node.h"

namespace touchdown::config {

/// The unit in which a key's number is written, and the way to SI: SI = written * scale / divisor.
struct Unit {
  std::string_view name;
  double scale = 1.0;
  double divisor = 1.0;

  double ToSi(double written) const { return written * scale / divisor; }
};

inline constexpr Unit kNoUnit{"-"}, kMetre{"m"}, kSecond{"s"}, kMillisecond{"ms", 1.0, 1000.0}, kKilogram{"kg"},
    kNewton{"N"}, kMetrePerSecond{"m/s"}, kMetrePerSecond2{"m/s^2"}, kRadianPerSecond{"rad/s"}, kPixel{"px"},
    kHertz{"Hz"}, kPerSecond{"1/s"}, kMetrePerSecond2RootHertz{"m/s^2/sqrt(Hz)"}, kDegree{"deg", models::kPi / 180.0},
    kDegreePerSecond{"deg/s", models::kPi / 180.0};

/// The numbers that a key takes, in the key's unit.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_is_open = false;  ///< `min` itself is out of range.

  bool Contains(double written) const { return (min_is_open ? written > min : written >= min) && written <= max; }
  /// "must be above 0 and at most 3".
  std::string Describe() const;
};

inline constexpr Range kAny{}, kPositive{.min = 0.0, .min_is_open = true}, kNotNegative{.min = 0.0},
    kFraction{.min = 0.0, .max = 1.0};
constexpr Range Between(double min, double max) { return {.min = min, .max = max}; }
constexpr Range PositiveUpTo(double max) { return {.min = 0.0, .max = max, .min_is_open = true}; }

inline constexpr Range kImageSize_px = Between(1, 16384);

/// Of times in seconds: ten hours is beyond every flight.
inline constexpr double kLongest_s = 36000.0;
inline constexpr Range kPositiveTime = PositiveUpTo(kLongest_s), kTime = Between(0.0, kLongest_s);

/// A key and what it means, for the reference.
struct Key {
  std::string_view name;
  std::string_view doc;
  bool required = false;  ///< Must be given; for keys of a list's items and of the root.
};

/// How a section may be written other than in place.
struct SectionFile {
  bool allowed = false;  ///< The value may be the name of a file that holds the section's keys.
  /// Turns the file's root into the section's keys when the file is in a format of its own; may be null.
  std::function<ConfigNode(ConfigNode)> translate;
};

/// Sees every field of a configuration, one after the other. Each struct is described once, by a function
/// `void Describe(ConfigVisitor&, Struct&)` in scenario_schema.cc; reading, writing, checking and documenting are
/// visitors. A visitor that reads sets a field as it is visited, so a description may depend on earlier fields.
class ConfigVisitor {
 public:
  virtual ~ConfigVisitor() = default;

  virtual void Number(const Key& key, double& value_si, const Unit& unit, const Range& range) = 0;
  virtual void OptionalNumber(const Key& key, std::optional<double>& value_si, const Unit& unit,
                              const Range& range) = 0;
  /// A list of so many numbers.
  virtual void Numbers(const Key& key, const std::vector<double*>& values_si, const Unit& unit, const Range& range) = 0;
  virtual void Integer64(const Key& key, std::int64_t& value, const Range& range) = 0;
  virtual void Boolean(const Key& key, bool& value) = 0;
  virtual void Text(const Key& key, std::string& value) = 0;
  /// One of the names; `index` is its place among them, -1 for not given.
  virtual void Choice(const Key& key, int& index, std::span<const std::string_view> names) = 0;

  /// Keys within a key.
  virtual void Section(const Key& key, const SectionFile& file,
                       const std::function<void(ConfigVisitor&)>& describe) = 0;
  /// Keys within a key that may be absent altogether: `is_set` tells whether it is there already. Visitors that read no
  /// text describe what is set.
  virtual void OptionalSection(const Key& key, bool is_set, const SectionFile& file,
                               const std::function<void(ConfigVisitor&)>& describe) {
    if (is_set) Section(key, file, describe);
  }
  /// A list of sections. `resize` is called with the count of items before they are described.
  virtual void List(const Key& key, std::size_t count, const std::function<void(std::size_t)>& resize,
                    const std::function<void(ConfigVisitor&, std::size_t)>& describe) = 0;

  /// A key of the section being visited that got a new name, `new_key`, as seen from the section. Written, it is an
  /// error that names the new one.
  virtual void Renamed(std::string_view /*old_key*/, std::string_view /*new_key*/) {}

  /// What must hold of a key of the section being visited (of the whole section: ""), beyond its range, once everything
  /// is read: `check` throws InputError without a place.
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
  void Keys(const Key& key, T& section) {
    Section(key, {}, [&section](ConfigVisitor& v) { Describe(v, section); });
  }

  /// Where the section is there, the keys that it leaves out are those of `otherwise`.
  template <typename T>
  void OptionalKeys(const Key& key, std::optional<T>& section, const T& otherwise, const SectionFile& file = {}) {
    OptionalSection(key, section.has_value(), file, [&section, &otherwise](ConfigVisitor& v) {
      if (!section) section = otherwise;
      Describe(v, *section);
    });
  }

  template <typename T>
  void KeysOrFile(const Key& key, T& section, std::function<ConfigNode(ConfigNode)> translate = nullptr) {
    Section(key, {true, std::move(translate)}, [&section](ConfigVisitor& v) { Describe(v, section); });
  }
};

}  // namespace touchdown::config
