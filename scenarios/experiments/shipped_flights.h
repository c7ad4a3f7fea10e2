#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace touchdown::experiments {

/// The scenarios of scenarios/flights, by their files' names without ending. The build puts them into the program.
const std::vector<std::pair<std::string_view, std::string_view>>& ShippedFlights();

}  // namespace touchdown::experiments
