#include "scenarios/experiments/paper_report.h"

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <string_view>

#include "scenarios/report/page_assets.h"
#include "scenarios/report/section_page.h"
#include "scenarios/util/csv_writer.h"

namespace touchdown::experiments {
namespace {

using kainjow::mustache::data;
using Files = std::map<std::string, std::string>;

data Flag(bool on) { return on ? data::type::bool_true : data::type::bool_false; }

std::string ThreeDigits(double value) { return value == 0.0 ? "0" : fmt::format("{:.3g}", value); }

std::string ValueOrDash(const std::optional<double>& value) { return value ? ThreeDigits(*value) : "–"; }

std::string Ratio(const ComparedQuantity& row) {
  const bool is_defined = row.ours && row.published && *row.published > 0.0;
  return is_defined ? fmt::format("{:.2f}", *row.ours / *row.published) : "–";
}

/// Comparison with the published value in words; empty if there is no published value.
std::string Verdict(const ComparedQuantity& row) {
  if (!row.published) return "";
  if (!row.ours) return "none";
  return row.MeetsPublished() ? "at or below" : "above";
}

std::string SummaryCsv(const std::vector<PaperSection>& sections) {
  std::string csv = "section,quantity,unit,published,ours,spread,kept,why\n";
  for (const PaperSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      csv += util::CsvLine({section.id, row.quantity, row.unit, row.published ? fmt::format("{}", *row.published) : "",
                            row.ours ? fmt::format("{:.6g}", *row.ours) : "", row.spread,
                            !row.published         ? ""
                            : row.MeetsPublished() ? "yes"
                                                   : "no",
                            row.why});
    }
  }
  return csv;
}

data RowData(const ComparedQuantity& row) {
  data result;
  result.set("quantity", row.quantity);
  result.set("unit", row.unit);
  result.set("published", ValueOrDash(row.published));
  result.set("ours", ValueOrDash(row.ours));
  result.set("ratio", Ratio(row));
  result.set("spread", row.spread);
  result.set("why", row.why);
  result.set("compares", Flag(row.published.has_value()));
  result.set("kept", Flag(row.MeetsPublished()));
  result.set("verdict", Verdict(row));
  return result;
}

std::string MarkdownRow(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

/// Maximum size, in bytes, of a figure in the README. Larger ones are time series with thousands of points, which only
/// the page shows.
constexpr std::size_t kMaxReadmeFigure = 100'000;

/// Content of README.md. `files` must contain the rendered figures.
std::string Readme(const ReportHead& head, const std::vector<PaperSection>& sections, const Files& files) {
  std::string text = fmt::format(
      "# The paper, measured\n\n"
      "Made by `{}`; do not edit. The table compares every quantity of the paper with\n"
      "the measured one. `report.html` in the output directory is the page with all tables and figures.\n"
      "`figures/` contains each of them as CSV and PDF, and `table_1.tex` is Table I for LaTeX.\n\n",
      head.command);
  text += MarkdownRow({"quantity", "unit", "published", "ours", "ratio", "kept", "spread"});
  text += MarkdownRow({"---", "---", "---:", "---:", "---:", "---", "---"});
  for (const PaperSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      std::string quantity = row.quantity;
      for (std::size_t at = 0; (at = quantity.find('|', at)) != std::string::npos; at += 2)
        quantity.insert(at, 1, '\\');
      text += MarkdownRow({quantity, row.unit, ValueOrDash(row.published), ValueOrDash(row.ours), Ratio(row),
                           Verdict(row), row.spread});
    }
  }
  for (const PaperSection& section : sections) {
    std::vector<const report::Figure*> figures;
    for (const report::Figure& each : section.figures) {
      if (files.at(fmt::format("figures/{}.svg", each.name)).size() <= kMaxReadmeFigure) figures.push_back(&each);
    }
    if (figures.empty() && section.images.empty()) continue;
    text += fmt::format("\n## {}\n", section.title);
    for (const report::ReportImage& each : section.images)
      text += fmt::format("\n![{0}](figures/{1}.jpg)\n", each.title, each.name);
    for (const report::Figure* each : figures)
      text += fmt::format("\n![{0}](figures/{1}.svg)\n", each->title, each->name);
  }
  return text;
}

std::string Page(const ReportHead& head, const std::vector<PaperSection>& sections, Files& files) {
  data compared{data::type::list}, contents{data::type::list}, platform{data::type::list};
  std::string parts;
  int kept = 0, all = 0;
  for (const PaperSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      compared << RowData(row);
      if (!row.published) continue;
      ++all;
      kept += row.MeetsPublished() ? 1 : 0;
    }
    data entry;
    entry.set("id", section.id);
    entry.set("title", section.title);
    contents << entry;
    report::SectionWithFiles part = report::DrawSection(section);
    parts += part.html;
    files.merge(part.files);
  }
  for (const auto& [name, value] : head.platform) {
    data item;
    item.set("name", name);
    item.set("value", value);
    platform << item;
  }
  data page;
  page.set("signature", head.signature);
  page.set("style", std::string(report::PageStyle()));
  page.set("command", head.command);
  page.set("quick", Flag(head.quick));
  page.set("kept", fmt::format("{} of {}", kept, all));
  page.set("all_kept", Flag(kept == all));
  page.set("compared", compared);
  page.set("contents", contents);
  page.set("sections", parts);
  page.set("platform", platform);
  kainjow::mustache::mustache page_template{std::string(report::PaperPageTemplate())};
  if (!page_template.is_valid()) throw std::logic_error("the paper page's template: " + page_template.error_message());
  return page_template.render(page);
}

}  // namespace

std::map<std::string, std::string> ReportFiles(const ReportHead& head, const std::vector<PaperSection>& sections) {
  Files files;
  files["report.html"] = Page(head, sections, files);
  files["README.md"] = Readme(head, sections, files);
  files["summary.csv"] = SummaryCsv(sections);
  return files;
}

}  // namespace touchdown::experiments
