#include "scenarios/report/section_page.h"

#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "scenarios/report/jpeg_pdf.h"
#include "scenarios/report/page_assets.h"
#include "scenarios/util/base64.h"
#include "scenarios/util/csv_writer.h"

namespace touchdown::report {
namespace {

using kainjow::mustache::data;
using Files = std::map<std::string, std::string>;

constexpr double kPagePxPerCm = 56.0;
constexpr double kImageWidth_cm = 17.0;

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

data FigureData(const Figure& figure, const DrawnFigure& drawn) {
  data result;
  result.set("name", figure.name);
  result.set("title", figure.title);
  result.set("caption", figure.caption);
  result.set("svg", drawn.page_svg);
  result.set("width", fmt::format("{:.0f}", kPagePxPerCm * figure.width_cm));
  return result;
}

data ImageData(const ReportImage& image) {
  data result;
  result.set("name", image.name);
  result.set("title", image.title);
  result.set("caption", image.caption);
  result.set("base64", util::Base64(image.jpeg));
  return result;
}

void AddFiles(const Figure& figure, const DrawnFigure& drawn, Files& files) {
  files["figures/" + figure.name + ".csv"] = figure.csv;
  files["figures/" + figure.name + ".pdf"] = drawn.pdf;
  files["figures/" + figure.name + ".svg"] = drawn.svg;
}

void AddFiles(const ReportImage& image, Files& files) {
  files["figures/" + image.name + ".jpg"] = image.jpeg;
  files["figures/" + image.name + ".pdf"] = JpegPdf(image.jpeg, kImageWidth_cm);
  files["figures/" + image.name + ".csv"] = image.csv;
}

void AddFiles(const ReportTable& table, Files& files) {
  std::string csv = util::CsvLine(table.head);
  for (const auto& row : table.rows) csv += util::CsvLine(row);
  files["figures/" + table.name + ".table.csv"] = csv;
}

std::string Html(const ReportSection& section, const std::vector<DrawnFigure>& drawn, bool has_files) {
  data paragraphs{data::type::list}, figures{data::type::list}, images{data::type::list}, tables{data::type::list};
  for (const std::string& paragraph : section.paragraphs) paragraphs << data{"html", paragraph};
  for (std::size_t i = 0; i < drawn.size(); ++i) figures << FigureData(section.figures[i], drawn[i]);
  for (const ReportImage& image : section.images) images << ImageData(image);
  for (const ReportTable& table : section.tables) tables << TableData(table);
  data part;
  part.set("id", section.id);
  part.set("title", section.title);
  part.set("paragraphs", paragraphs);
  part.set("figures", figures);
  part.set("images", images);
  part.set("tables", tables);
  part.set("has_files", has_files ? data::type::bool_true : data::type::bool_false);
  kainjow::mustache::mustache part_template{std::string(SectionTemplate())};
  if (!part_template.is_valid()) throw std::logic_error("section template: " + part_template.error_message());
  return part_template.render(part);
}

std::vector<DrawnFigure> DrawAll(const std::vector<Figure>& figures) {
  std::vector<DrawnFigure> drawn;
  for (const Figure& figure : figures) drawn.push_back(Draw(figure));
  return drawn;
}

}  // namespace

std::string SectionHtml(const ReportSection& section) { return Html(section, DrawAll(section.figures), false); }

SectionWithFiles DrawSection(const ReportSection& section) {
  const std::vector<DrawnFigure> drawn = DrawAll(section.figures);
  SectionWithFiles result{.html = Html(section, drawn, true), .files = {}};
  for (std::size_t i = 0; i < drawn.size(); ++i) AddFiles(section.figures[i], drawn[i], result.files);
  for (const ReportImage& image : section.images) AddFiles(image, result.files);
  for (const ReportTable& table : section.tables) AddFiles(table, result.files);
  return result;
}

}  // namespace touchdown::report
