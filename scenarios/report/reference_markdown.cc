#include "scenarios/report/reference_markdown.h"

#include <fmt/format.h>

#include <string_view>

#include "scenarios/flight/metrics.h"
#include "scenarios/flight/scenario.h"

namespace touchdown::scenarios {
namespace {

std::string Code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

std::string_view WithoutMustBe(std::string_view range) {
  constexpr std::string_view kPrefix = "must be ";
  return range.starts_with(kPrefix) ? range.substr(kPrefix.size()) : range;
}

}  // namespace

std::string KeysMarkdown() {
  std::string table = "| key | unit | default | allowed | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const ScenarioKey& key : ScenarioReference()) {
    table += fmt::format("| {} | {} | {} | {} | {} |\n", Code(key.path), key.unit == "-" ? "" : key.unit,
                         Code(key.default_value), WithoutMustBe(key.range), key.doc);
  }
  return table;
}

std::string MetricsMarkdown() {
  std::string table = "| metric | unit | meaning |\n| --- | --- | --- |\n";
  for (const MetricInfo& info : AllMetrics()) {
    table += fmt::format("| {} | {} | {} |\n", Code(info.name), info.unit, info.doc);
  }
  return table;
}

}  // namespace touchdown::scenarios
