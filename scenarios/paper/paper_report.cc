#include "scenarios/paper/paper_report.h"

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <string_view>

#include "scenarios/paper/base64.h"
#include "scenarios/paper/text.h"
#include "scenarios/report/page_assets.h"
#include "scenarios/report/picture_pdf.h"

namespace touchdown::scenarios {
namespace {

using kainjow::mustache::data;
using Files = std::map<std::string, std::string>;

constexpr double kPagePxPerCm = 56.0;
constexpr double kPictureWidth_cm = 17.0;

data Flag(bool on) { return on ? data::type::bool_true : data::type::bool_false; }

std::string Figure3(double value) { return value == 0.0 ? "0" : fmt::format("{:.3g}", value); }

std::string FigureOrDash(const std::optional<double>& value) { return value ? Figure3(*value) : "–"; }

std::string Ratio(const ComparedQuantity& row) {
  const bool is_defined = row.ours && row.published && *row.published > 0.0;
  return is_defined ? fmt::format("{:.2f}", *row.ours / *row.published) : "–";
}

/// Whether it is kept in words, or nothing where there is nothing to compare with.
std::string Verdict(const ComparedQuantity& row) {
  if (!row.published) return "";
  if (!row.ours) return "none";
  return row.IsKept() ? "at or below" : "above";
}

/// A cell of CSV, quoted where it must be.
std::string Quoted(std::string text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return '"' + text + '"';
}

std::string QuotedLine(const std::vector<std::string>& cells) {
  std::vector<std::string> quoted;
  for (const std::string& cell : cells) quoted.push_back(Quoted(cell));
  return CsvLine(quoted);
}

std::string SummaryCsv(const std::vector<ReportSection>& sections) {
  std::string csv = "section,quantity,unit,published,ours,spread,kept,why\n";
  for (const ReportSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      csv += QuotedLine({section.id, row.quantity, row.unit, row.published ? fmt::format("{}", *row.published) : "",
                         row.ours ? fmt::format("{:.6g}", *row.ours) : "", row.spread,
                         !row.published ? ""
                         : row.IsKept() ? "yes"
                                        : "no",
                         row.why});
    }
  }
  return csv;
}

data TableData(const ReportTable& table) {
  data head{data::type::list}, rows{data::type::list};
  for (const std::string& cell : table.head) head << data{"text", cell};
  for (const auto& row : table.rows) {
    data cells{data::type::list};
    for (std::size_t i = 1; i < row.size(); ++i) cells << data{"text", row[i]};
    data line;
    line.set("first", row.front());
    line.set("cells", cells);
    rows << line;
  }
  data result;
  result.set("name", table.name);
  result.set("caption", table.caption);
  result.set("head", head);
  result.set("rows", rows);
  return result;
}

data RowData(const ComparedQuantity& row) {
  data result;
  result.set("quantity", row.quantity);
  result.set("unit", row.unit);
  result.set("published", FigureOrDash(row.published));
  result.set("ours", FigureOrDash(row.ours));
  result.set("ratio", Ratio(row));
  result.set("spread", row.spread);
  result.set("why", row.why);
  result.set("compares", Flag(row.published.has_value()));
  result.set("kept", Flag(row.IsKept()));
  result.set("verdict", Verdict(row));
  return result;
}

/// Draws the section's figures into `files`, and tells the page of them.
data SectionData(const ReportSection& section, Files& files) {
  data paragraphs{data::type::list}, figures{data::type::list}, pictures{data::type::list}, tables{data::type::list};
  for (const std::string& paragraph : section.paragraphs) paragraphs << data{"html", paragraph};
  for (const Figure& figure : section.figures) {
    const DrawnFigure drawn = Draw(figure);
    files["figures/" + figure.name + ".csv"] = figure.csv;
    files["figures/" + figure.name + ".pdf"] = drawn.pdf;
    files["figures/" + figure.name + ".svg"] = drawn.svg;
    data item;
    item.set("name", figure.name);
    item.set("title", figure.title);
    item.set("caption", figure.caption);
    item.set("svg", drawn.page_svg);
    item.set("width", fmt::format("{:.0f}", kPagePxPerCm * figure.width_cm));
    figures << item;
  }
  for (const ReportPicture& picture : section.pictures) {
    files["figures/" + picture.name + ".jpg"] = picture.jpeg;
    files["figures/" + picture.name + ".pdf"] = PicturePdf(picture.jpeg, kPictureWidth_cm);
    files["figures/" + picture.name + ".csv"] = picture.csv;
    data item;
    item.set("name", picture.name);
    item.set("title", picture.title);
    item.set("caption", picture.caption);
    item.set("base64", Base64(picture.jpeg));
    pictures << item;
  }
  for (const ReportTable& table : section.tables) {
    std::string csv = QuotedLine(table.head);
    for (const auto& row : table.rows) csv += QuotedLine(row);
    files["figures/" + table.name + ".table.csv"] = csv;
    tables << TableData(table);
  }
  data result;
  result.set("id", section.id);
  result.set("title", section.title);
  result.set("paragraphs", paragraphs);
  result.set("figures", figures);
  result.set("pictures", pictures);
  result.set("tables", tables);
  return result;
}

std::string MarkdownRow(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string Readme(const ReportHead& head, const std::vector<ReportSection>& sections) {
  std::string text = fmt::format(
      "# The paper, measured\n\nMade by `{}`; do not edit. Every figure of the paper beside ours: "
      "[report.html](report.html) is the same as one page, with all tables and figures and a word on each; `figures/` "
      "holds each as CSV and PDF, `table_1.tex` Table I for LaTeX.\n\n",
      head.command);
  text += MarkdownRow({"quantity", "unit", "published", "ours", "ratio", "kept", "spread"});
  text += MarkdownRow({"---", "---", "---:", "---:", "---:", "---", "---"});
  for (const ReportSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      std::string quantity = row.quantity;
      for (std::size_t at = 0; (at = quantity.find('|', at)) != std::string::npos; at += 2)
        quantity.insert(at, 1, '\\');
      text += MarkdownRow({quantity, row.unit, FigureOrDash(row.published), FigureOrDash(row.ours), Ratio(row),
                           Verdict(row), row.spread});
    }
  }
  for (const ReportSection& section : sections) {
    if (section.figures.empty() && section.pictures.empty()) continue;
    text += fmt::format("\n## {}\n", section.title);
    for (const ReportPicture& each : section.pictures)
      text += fmt::format("\n![{0}](figures/{1}.jpg)\n", each.title, each.name);
    for (const Figure& each : section.figures)
      text += fmt::format("\n![{0}](figures/{1}.svg)\n", each.title, each.name);
  }
  return text;
}

std::string Page(const ReportHead& head, const std::vector<ReportSection>& sections, Files& files) {
  data compared{data::type::list}, parts{data::type::list}, platform{data::type::list};
  int kept = 0, all = 0;
  for (const ReportSection& section : sections) {
    for (const ComparedQuantity& row : section.compared) {
      compared << RowData(row);
      if (!row.published) continue;
      ++all;
      kept += row.IsKept() ? 1 : 0;
    }
    parts << SectionData(section, files);
  }
  for (const auto& [name, value] : head.platform) {
    data item;
    item.set("name", name);
    item.set("value", value);
    platform << item;
  }
  data page;
  page.set("mark", head.mark);
  page.set("style", std::string(PageStyle()));
  page.set("command", head.command);
  page.set("quick", Flag(head.quick));
  page.set("kept", fmt::format("{} of {}", kept, all));
  page.set("all_kept", Flag(kept == all));
  page.set("compared", compared);
  page.set("sections", parts);
  page.set("platform", platform);
  kainjow::mustache::mustache page_template{std::string(PaperPageTemplate())};
  if (!page_template.is_valid()) throw std::logic_error("the paper page's template: " + page_template.error_message());
  return page_template.render(page);
}

}  // namespace

std::map<std::string, std::string> ReportFiles(const ReportHead& head, const std::vector<ReportSection>& sections) {
  Files files;
  files["report.html"] = Page(head, sections, files);
  files["README.md"] = Readme(head, sections);
  files["summary.csv"] = SummaryCsv(sections);
  return files;
}

}  // namespace touchdown::scenarios
