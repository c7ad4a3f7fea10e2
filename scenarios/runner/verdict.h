#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace touchdown::runner {

enum class Verdict {
  kPass,   ///< The flight met every check.
  kFail,   ///< The flight missed a check.
  kError,  ///< The simulation failed.
};
inline constexpr std::array<std::string_view, 3> kVerdictNames = {"pass", "fail", "error"};
constexpr const auto& NamesOf(Verdict) { return kVerdictNames; }
constexpr std::string_view Name(Verdict verdict) { return kVerdictNames[static_cast<std::size_t>(verdict)]; }

}  // namespace touchdown::runner
