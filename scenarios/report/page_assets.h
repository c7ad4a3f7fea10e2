#pragma once

#include <string_view>

namespace touchdown::report {

// The parts of the pages that every page has, from scenarios/report/web/. The build puts them into the program.

/// The page as a mustache template.
std::string_view PageTemplate();

/// The page of the paper's experiments as a mustache template; its style sheet is the same.
std::string_view PaperPageTemplate();

/// The page of a sweep, likewise.
std::string_view SweepPageTemplate();

/// A section of these two pages as a mustache template.
std::string_view SectionTemplate();

/// Its style sheet.
std::string_view PageStyle();

/// Its script, with uPlot.
std::string_view PageScript();

}  // namespace touchdown::report
