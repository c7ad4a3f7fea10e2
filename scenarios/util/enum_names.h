#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace touchdown::util {

/// Enum value with the given name; nullopt for an unknown name.
///
/// A function `NamesOf(Enum)` must return an array of the names, in the order of the enum values, which count up from
/// 0.
template <typename Enum>
constexpr std::optional<Enum> EnumFromName(std::string_view name) {
  const auto& names = NamesOf(Enum{});
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace touchdown::util
