#pragma once

#include <string_view>

namespace touchdown::util {

/// The project's version, "0.2.0".
std::string_view Version();

}  // namespace touchdown::util
