#include "scenarios/report/reference_markdown.h"

#include <fmt/format.h>

#include <string_view>

#include "scenarios/runner/metrics.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::report {
namespace {

std::string Code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

std::string_view WithoutMustBe(std::string_view range) {
  constexpr std::string_view kPrefix = "must be ";
  return range.starts_with(kPrefix) ? range.substr(kPrefix.size()) : range;
}

}  // namespace

std::string KeysMarkdown() {
  std::string table = "| key | unit | default | allowed | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const config::KeyRow& key : runner::ScenarioReference()) {
    table += fmt::format("| {} | {} | {} | {} | {} |\n", Code(key.path), key.unit == "-" ? "" : key.unit,
                         Code(key.default_value), WithoutMustBe(key.range), key.doc);
  }
  return table;
}

std::string MetricsMarkdown() {
  std::string table = "| metric | unit | meaning |\n| --- | --- | --- |\n";
  for (const runner::MetricInfo& info : runner::AllMetrics()) {
    table += fmt::format("| {} | {} | {} |\n", Code(info.name), info.unit, info.doc);
  }
  return table;
}

}  // namespace touchdown::report
