#pragma once

#include <string>

namespace touchdown::report {

/// Markdown table of all scenario keys: unit, default, allowed range and meaning.
std::string KeysMarkdown();

/// Markdown table of all metrics: unit and meaning.
std::string MetricsMarkdown();

}  // namespace touchdown::report
