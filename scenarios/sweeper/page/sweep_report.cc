#include "scenarios/sweeper/page/sweep_report.h"

#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "scenarios/report/page_assets.h"
#include "scenarios/report/section_page.h"
#include "scenarios/sweeper/page/pass_rate_figures.h"
#include "scenarios/sweeper/page/sweep_sections.h"
#include "scenarios/util/shell_word.h"
#include "scenarios/util/text.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;

constexpr int kMaxImages = 50;

data Flag(bool on) { return on ? data::type::bool_true : data::type::bool_false; }

/// Adds the result of a boundary search. The pass rate is not meaningful, because the flights concentrate near the
/// boundary.
template <typename Put>
void PutBoundary(const PassBoundaryOf& each, const Put& put) {
  if (!each.boundary) {
    put("No boundary found", "all flights have the same result", "");
    return;
  }
  put("Boundary", fmt::format("{:.4g}", each.boundary->value), "");
  put("95 % interval", fmt::format("{:.4g}–{:.4g}", each.boundary->low, each.boundary->high), "");
}

/// Key figures at the top of the page.
data KeyFigures(const SweepOutcome& sweep, const SweepSummary& summary) {
  data items{data::type::list};
  const auto put = [&items](const char* label, const std::string& value, const char* unit) {
    data item;
    item.set("label", label);
    item.set("value", value);
    item.set("unit", unit);
    items << item;
  };
  if (sweep.spec.search) {
    for (const PassBoundaryOf& each : summary.boundaries) PutBoundary(each, put);
  } else if (summary.all.flown > 0) {
    put("Passed", RateText(summary.all), "%");
    put(sweep.spec.stop_when ? "95 % interval (Wilson), not corrected for the early stop" : "95 % interval (Wilson)",
        RateInterval(summary.all), "%");
  }
  put("Flights that passed", std::to_string(summary.all.passed), "");
  put("Flights that failed", std::to_string(summary.all.flown - summary.all.passed), "");
  put("Flown", std::to_string(summary.all.flown), "");
  put("Planned", std::to_string(sweep.planned), "");
  if (sweep.total > sweep.planned)
    put("Flights of the whole sweep, of which this is a part", std::to_string(sweep.total), "");
  if (sweep.unplanned > 0) put("Flown before the sweep file changed, not counted", std::to_string(sweep.unplanned), "");
  if (sweep.stale > 0) put("Flown by another build, not counted", std::to_string(sweep.stale), "");
  return items;
}

data Texts(const std::vector<std::string>& texts) {
  data items{data::type::list};
  for (const std::string& text : texts) items << data{"text", text};
  return items;
}

/// Column heads of a failure: seed, variant (if there are variants) and parameters.
std::vector<std::string> FailureHead(const SweepSpec& spec) {
  std::vector<std::string> head{"Seed"};
  if (!spec.variants.empty()) head.push_back("Variant");
  for (const SweepAxis& axis : spec.axes) head.push_back(axis.key);
  return head;
}

std::vector<std::string> FailureCells(const SweepSpec& spec, const SweepResult& result) {
  std::vector<std::string> cells{std::to_string(result.seed)};
  if (!spec.variants.empty()) cells.push_back(result.variant);
  for (std::size_t i = 0; i < spec.axes.size(); ++i) {
    const auto drawn = spec.axes[i].listed.empty() ? AsNumber(result.values[i]) : std::nullopt;
    cells.push_back(drawn ? fmt::format("{:.4g}", *drawn) : result.values[i]);
  }
  return cells;
}

data FailureData(const SweepSpec& spec, const SweepResult& result, const fs::path& folder) {
  const FlightRow& row = result.row;
  data failure;
  failure.set("id", row.id);
  failure.set("command", fmt::format("touchdown fly --from {} {}", util::ShellWord(folder.string()), row.id));
  failure.set("cause", CauseOf(row));
  failure.set("reason", row.reason);
  failure.set("stderr_tail", row.stderr_tail);
  failure.set("has_stderr", Flag(!row.stderr_tail.empty()));
  failure.set("cells", Texts(FailureCells(spec, result)));
  const std::string image = "pictures/" + row.id + ".png";
  std::error_code error;
  failure.set("image", image);
  failure.set("has_image", Flag(fs::exists(folder / image, error)));
  return failure;
}

void PutFailures(const SweepOutcome& sweep, const fs::path& folder, data& page) {
  data failures{data::type::list};
  int count = 0;
  for (const SweepResult& result : sweep.results) {
    if (result.row.passed()) continue;
    data failure = FailureData(sweep.spec, result, folder);
    failure.set("shown", Flag(count < kMaxImages));
    failures << failure;
    ++count;
  }
  page.set("head", Texts(FailureHead(sweep.spec)));
  page.set("failures", failures);
  page.set("has_failures", Flag(count > 0));
  page.set("cut", Flag(count > kMaxImages));
  page.set("max_images", std::to_string(kMaxImages));
}

void PutSections(const std::vector<report::ReportSection>& sections, data& page) {
  data contents{data::type::list};
  std::string html;
  const auto add_entry = [&contents](const std::string& id, const std::string& title) {
    data entry;
    entry.set("id", id);
    entry.set("title", title);
    contents << entry;
  };
  for (const report::ReportSection& section : sections) {
    add_entry(section.id, section.title);
    html += report::SectionHtml(section);
  }
  add_entry("failures", "Failures");
  page.set("contents", contents);
  page.set("sections", html);
}

}  // namespace

std::string SweepPage(const SweepOutcome& sweep, const SweepSummary& summary, const fs::path& folder) {
  data page;
  page.set("signature", kSweepPageSignature);
  page.set("style", std::string(report::PageStyle()));
  page.set("name", sweep.spec.name);
  page.set("description", sweep.spec.description);
  page.set("has_criteria", Flag(!summary.criteria.empty() && summary.is_complete));
  page.set("kept", Flag(summary.meets_criteria()));
  const std::size_t missing = sweep.total - std::min(sweep.total, sweep.results.size());
  page.set("missing", std::to_string(missing));
  page.set("is_partial", Flag(missing > 0));
  page.set("total", std::to_string(sweep.total));
  page.set("glance", KeyFigures(sweep, summary));
  PutSections(SweepSections(sweep, summary), page);
  PutFailures(sweep, folder, page);
  kainjow::mustache::mustache page_template{std::string(report::SweepPageTemplate())};
  if (!page_template.is_valid()) throw std::logic_error("sweep page template: " + page_template.error_message());
  return page_template.render(page);
}

}  // namespace touchdown::sweeper
