#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace touchdown::util {

/// Value of an enum by its name; nullopt for an unknown name.
///
/// The enum has its names beside it: a function `NamesOf(Enum)` that returns an array of them, in the
/// order of the enum's values, which count up from 0.
template <typename Enum>
constexpr std::optional<Enum> EnumFromName(std::string_view name) {
  const auto& names = NamesOf(Enum{});
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

}  // namespace touchdown::util
