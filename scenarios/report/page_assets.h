#pragma once

#include <string_view>

namespace touchdown::report {

// Templates, style sheet and script of the HTML pages, from scenarios/report/web/. The build embeds them in the
// library.

/// Mustache template of the flight report.
std::string_view PageTemplate();

/// Mustache template of the report on the experiments of the paper.
std::string_view PaperPageTemplate();

/// Mustache template of the sweep report.
std::string_view SweepPageTemplate();

/// Mustache template of a section of the paper report and of the sweep report.
std::string_view SectionTemplate();

/// Style sheet of all pages.
std::string_view PageStyle();

/// Script of the flight report, bundled with uPlot.
std::string_view PageScript();

}  // namespace touchdown::report
