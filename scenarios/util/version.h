#pragma once

#include <string_view>

namespace touchdown::util {

/// Version of the project, for example "0.2.0".
std::string_view Version();

}  // namespace touchdown::util
