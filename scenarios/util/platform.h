#pragma once

#include <string>
#include <utility>
#include <vector>

namespace touchdown::util {

/// Names and values of the platform properties that affect the last bits of a flight, in a fixed order.
std::vector<std::pair<std::string, std::string>> PlatformFacts();

/// Network name of this computer.
std::string HostName();

}  // namespace touchdown::util
