#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "models/error.h"

namespace touchdown::config {

/// Origin of a configuration node.
struct Origin {
  std::string place;             ///< For messages: "flight.yaml:12", or "--set camera.rate_hz=7".
  std::filesystem::path folder;  ///< Base folder of file names.
};

struct ConfigEntry;

/// Node of a configuration: a scalar, a list, or keys with values. It represents YAML without anchors, tags and
/// duplicate keys.
struct ConfigNode {
  enum class Kind { kNothing, kText, kList, kKeys };

  Kind kind = Kind::kNothing;
  Origin origin;
  std::string text;
  bool quoted = false;            ///< The text was quoted, so it is not a number.
  std::vector<ConfigNode> items;  ///< Items of a list.
  std::vector<ConfigEntry> keys;
  /// The keys change an existing configuration (--set). For a list, the keys are indices of items.
  bool patch = false;

  /// The value of a key; nullptr when absent.
  const ConfigNode* Find(std::string_view key) const;
};

/// A key and its value.
struct ConfigEntry {
  std::string key;
  ConfigNode node;
};

/// Error with the message "place: path: message". Control characters are replaced, so that it has one line. `path` may
/// be empty.
InputError ConfigError(const Origin& origin, std::string_view path, std::string_view message);

/// Reads a YAML file with one document whose root is a map. Throws InputError for a file that is missing, a folder, or
/// larger than 1 MiB; for a name or text that is not UTF-8; for text that is empty or not YAML; and for duplicate keys,
/// anchors, tags, or more than 32 levels.
ConfigNode ReadConfigFile(const std::filesystem::path& file);

/// Parses YAML text. `name` is its file name in messages. Throws like ReadConfigFile.
ConfigNode ParseConfig(const std::string& text, const std::string& name, const std::filesystem::path& folder);

/// Patch from "a.b.c=value" with a YAML value. `place` is its location in messages. Throws InputError if the key is
/// missing or the value is not YAML.
ConfigNode ParseOverride(const std::string& assignment, const std::string& place,
                         const std::filesystem::path& folder = {});

}  // namespace touchdown::config
