#pragma once

#include <string>
#include <utility>
#include <vector>

namespace touchdown::util {

/// What decides, beside scenario and seed, the last bits of a flight: names and values, in a fixed order.
std::vector<std::pair<std::string, std::string>> PlatformFacts();

/// Of the machine that this runs on.
std::string HostName();

}  // namespace touchdown::util
