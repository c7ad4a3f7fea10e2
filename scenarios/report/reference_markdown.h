#pragma once

#include <string>

namespace touchdown::report {

/// Every key of a scenario with unit, default, range and meaning, as a Markdown table.
std::string KeysMarkdown();

/// Every metric with its unit and meaning, as a Markdown table.
std::string MetricsMarkdown();

}  // namespace touchdown::report
