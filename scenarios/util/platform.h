#pragma once

#include <string>
#include <utility>
#include <vector>

namespace touchdown::util {

/// Properties that affect the last bits of a flight, apart from scenario and seed: names and values, in a fixed order.
std::vector<std::pair<std::string, std::string>> PlatformFacts();

/// Properties of this machine.
std::string HostName();

}  // namespace touchdown::util
