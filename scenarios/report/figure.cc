#include "scenarios/report/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <regex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "models/error.h"
#include "scenarios/report/page_assets.h"
#include "scenarios/util/file.h"
#include "scenarios/util/process.h"
#include "scenarios/util/scratch_folder.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

constexpr double kSvgUnitsPerCm = 48.0;

using Colors = std::vector<std::pair<std::string, std::string>>;

/// The page's colors by day, by the names of its variables: of each the first in its style sheet.
const Colors& PageColors() {
  static const Colors colors = [] {
    const std::string style(PageStyle());
    static const std::regex variable(R"(--([a-z-]+):\s*(#[0-9a-f]{6}))");
    Colors found;
    for (std::sregex_iterator match(style.begin(), style.end(), variable), end; match != end; ++match) {
      const std::string name = (*match)[1];
      const bool is_known =
          std::any_of(found.begin(), found.end(), [&](const auto& each) { return each.first == name; });
      if (!is_known) found.emplace_back(name, (*match)[2]);
    }
    return found;
  }();
  return colors;
}

void RunGnuplot(const fs::path& script) {
  const std::optional<util::ProcessResult> run = util::RunProcess({"gnuplot", script.string()});
  if (!run) {
    throw InputError("gnuplot, which draws the figures, cannot be run; on Debian: apt-get install gnuplot-nox");
  }
  if (!run->succeeded) throw std::runtime_error("gnuplot: " + run->err);
}

/// Throws InputError when the disk is full or the like.
void WriteInput(const fs::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

/// A file that gnuplot drew.
std::string ReadDrawing(const fs::path& file, const std::string& figure) {
  std::optional<std::string> drawing = util::ReadTextFileIfPresent(file);
  if (!drawing || drawing->empty()) throw std::runtime_error("gnuplot drew nothing of " + figure);
  return *std::move(drawing);
}

/// Names of the page's colors for the gnuplot commands: `lc rgb ESTIMATE`.
std::string ColorNames() {
  std::string commands;
  for (const auto& [name, hex] : PageColors()) {
    std::string upper;
    for (const char c : name) upper += c == '-' ? '_' : static_cast<char>(std::toupper(c));
    commands += fmt::format("{} = '{}'\n", upper, hex);
  }
  return commands;
}

std::string Style() {
  return ColorNames() + R"(set datafile separator comma
set datafile columnheaders
set border 3 lc rgb MUTED lw 0.8
set tics nomirror textcolor rgb MUTED scale 0.6
set grid lc rgb GRID lw 0.8 dt solid
set key textcolor rgb INK samplen 1.6 spacing 1.1
set xlabel textcolor rgb INK
set ylabel textcolor rgb INK
set title textcolor rgb INK
set style fill solid 0.85 noborder
)";
}

std::string Script(const Figure& figure, const fs::path& folder) {
  const auto part = [&](const std::string& terminal, const std::string& output) {
    return fmt::format("reset\nset terminal {}\nset output '{}'\n{}data = '{}'\n{}\nset output\n", terminal,
                       (folder / output).string(), Style(), (folder / "data.csv").string(), figure.plot);
  };
  return part(fmt::format("svg size {:.0f},{:.0f} dynamic font 'sans-serif,12'", kSvgUnitsPerCm * figure.width_cm,
                          kSvgUnitsPerCm * figure.height_cm),
              "figure.svg") +
         part(fmt::format("pdfcairo size {}cm,{}cm font 'DejaVu Sans,8' lw 1.2", figure.width_cm, figure.height_cm),
              "figure.pdf");
}

std::string Replaced(const std::string& text, const std::regex& pattern,
                     const std::function<std::string(const std::smatch&)>& replacement) {
  std::string result;
  auto from = text.cbegin();
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    result.append(from, text.cbegin() + match->position());
    result += replacement(*match);
    from = text.cbegin() + match->position() + match->length();
  }
  return result.append(from, text.cend());
}

std::string VariableFor(const std::string& hex, const std::string& otherwise) {
  for (const auto& [name, color] : PageColors()) {
    if (color == hex) return fmt::format("var(--{})", name);
  }
  return otherwise;
}

/// The drawing as a part of the page: no XML head, names of its own, the page's colors.
std::string ForThePage(const std::string& svg, const std::string& name) {
  std::string part = svg.substr(svg.find("<svg"));
  static const std::regex decimal(R"(rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\))"), hex("#[0-9a-fA-F]{6}"),
      id(R"((id=['"]|href=['"]#)(gp|gnuplot|textbox|greybox))");
  part = Replaced(part, decimal, [](const std::smatch& m) {
    const std::string as_hex = fmt::format("#{:02x}{:02x}{:02x}", std::stoi(m[1]), std::stoi(m[2]), std::stoi(m[3]));
    return VariableFor(as_hex, m.str());
  });
  part = Replaced(part, hex, [](const std::smatch& m) { return VariableFor(m.str(), m.str()); });
  return Replaced(part, id, [&](const std::smatch& m) { return fmt::format("{}{}_{}", m[1].str(), name, m[2].str()); });
}

/// Without the moment at which it was drawn, so that the same figure is the same file.
std::string Undated(std::string pdf) {
  static const std::string date = "/CreationDate (D:", never = "20000101000000";
  const std::size_t at = pdf.find(date);
  if (at != std::string::npos) pdf.replace(at + date.size(), never.size(), never);
  return pdf;
}

}  // namespace

DrawnFigure Draw(const Figure& figure) {
  const util::ScratchFolder folder;
  WriteInput(folder.path() / "data.csv", figure.csv);
  WriteInput(folder.path() / "figure.gp", Script(figure, folder.path()));
  RunGnuplot(folder.path() / "figure.gp");
  DrawnFigure drawn{.svg = ReadDrawing(folder.path() / "figure.svg", figure.name),
                    .page_svg = {},
                    .pdf = Undated(ReadDrawing(folder.path() / "figure.pdf", figure.name))};
  drawn.page_svg = ForThePage(drawn.svg, figure.name);
  return drawn;
}

}  // namespace touchdown::report
