#pragma once

#include <string_view>

namespace touchdown::scenarios {

// The parts of a flight's page that every flight has, from scenarios/report/web/. The build puts them into the program.

/// The page as a mustache template.
std::string_view PageTemplate();

/// Its style sheet.
std::string_view PageStyle();

/// Its script, with uPlot.
std::string_view PageScript();

}  // namespace touchdown::scenarios
