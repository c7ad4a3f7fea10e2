#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace touchdown::experiments {

/// Name and YAML text of each scenario in scenarios/flights, embedded at build time. The name is the file name without
/// extension.
const std::vector<std::pair<std::string_view, std::string_view>>& ShippedFlights();

}  // namespace touchdown::experiments
