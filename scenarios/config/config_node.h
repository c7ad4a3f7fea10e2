#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "models/error.h"

namespace touchdown::config {

/// Origin of a piece of configuration.
struct Origin {
  std::string place;             ///< For messages: "flight.yaml:12", or "--set camera.rate_hz=7".
  std::filesystem::path folder;  ///< Base folder of file names.
};

struct ConfigEntry;

/// A node of configuration text: a scalar, a list or keys with values. YAML without its anchors, tags and
/// duplicate keys.
struct ConfigNode {
  enum class Kind { kNothing, kText, kList, kKeys };

  Kind kind = Kind::kNothing;
  Origin origin;
  std::string text;
  bool quoted = false;            ///< The text was quoted, so it is not a number.
  std::vector<ConfigNode> items;  ///< Of a list.
  std::vector<ConfigEntry> keys;
  /// These keys patch an existing configuration (--set). In a list, keys are indices of items.
  bool patch = false;

  /// The value of a key; nullptr when absent.
  const ConfigNode* Find(std::string_view key) const;
};

/// A key and its value.
struct ConfigEntry {
  std::string key;
  ConfigNode node;
};

/// The error "place: path: message" in one line, whatever the parts contain. `path` may be empty.
InputError ConfigError(const Origin& origin, std::string_view path, std::string_view message);

/// Reads a YAML file of one document whose root is a map. Throws InputError for a file that is missing, a folder, not
/// UTF-8 in text or name, or over 1 MiB; for text that is empty or not YAML; and for duplicate keys, anchors, tags, and
/// nesting over 32.
ConfigNode ReadConfigFile(const std::filesystem::path& file);

/// Parses YAML text as of a file named `name`. Throws as ReadConfigFile does.
ConfigNode ParseConfig(const std::string& text, const std::string& name, const std::filesystem::path& folder);

/// Patch from "a.b.c=value" with a YAML value. `place` is its name in messages. Throws InputError without a key or for
/// a value that is not YAML.
ConfigNode ParseOverride(const std::string& assignment, const std::string& place,
                         const std::filesystem::path& folder = {});

}  // namespace touchdown::config
