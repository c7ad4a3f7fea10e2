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

/// Colors of the light theme with their CSS variable names: for each name its first value in the style sheet.
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
    throw InputError(
        "cannot run gnuplot, which draws the figures; install it, on Debian with: apt-get install gnuplot-nox");
  }
  if (!run->succeeded) throw std::runtime_error("gnuplot: " + run->err);
}

/// Throws InputError when the file cannot be written, for example when the disk is full.
void WriteInput(const fs::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

/// Content of a file that gnuplot wrote.
std::string ReadDrawing(const fs::path& file, const std::string& figure) {
  std::optional<std::string> drawing = util::ReadTextFileIfPresent(file);
  if (!drawing || drawing->empty()) throw std::runtime_error("gnuplot wrote no output for figure " + figure);
  return *std::move(drawing);
}

/// gnuplot variables with the colors of the page, for commands such as `lc rgb ESTIMATE`.
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
  const auto commands = [&](const std::string& terminal, const std::string& output) {
    return fmt::format("reset\nset terminal {}\nset output '{}'\n{}data = '{}'\n{}\nset output\n", terminal,
                       (folder / output).string(), Style(), (folder / "data.csv").string(), figure.plot);
  };
  return commands(fmt::format("svg size {:.0f},{:.0f} dynamic font 'sans-serif,12'", kSvgUnitsPerCm * figure.width_cm,
                              kSvgUnitsPerCm * figure.height_cm),
                  "figure.svg") +
         commands(fmt::format("pdfcairo size {}cm,{}cm font 'DejaVu Sans,8' lw 1.2", figure.width_cm, figure.height_cm),
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

std::string VariableFor(const std::string& hex, const std::string& fallback) {
  for (const auto& [name, color] : PageColors()) {
    if (color == hex) return fmt::format("var(--{})", name);
  }
  return fallback;
}

/// Converts a gnuplot SVG to an element of an HTML page: removes the XML header, makes the ids unique with the figure
/// name, and replaces the colors by CSS variables.
std::string PageSvg(const std::string& svg, const std::string& name) {
  std::string element = svg.substr(svg.find("<svg"));
  static const std::regex decimal(R"(rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\))"), hex("#[0-9a-fA-F]{6}"),
      id(R"((id=['"]|href=['"]#)(gp|gnuplot|textbox|greybox))");
  element = Replaced(element, decimal, [](const std::smatch& m) {
    const std::string as_hex = fmt::format("#{:02x}{:02x}{:02x}", std::stoi(m[1]), std::stoi(m[2]), std::stoi(m[3]));
    return VariableFor(as_hex, m.str());
  });
  element = Replaced(element, hex, [](const std::smatch& m) { return VariableFor(m.str(), m.str()); });
  return Replaced(element, id,
                  [&](const std::smatch& m) { return fmt::format("{}{}_{}", m[1].str(), name, m[2].str()); });
}

/// Replaces the creation date by a constant, so that equal figures give equal files.
std::string WithFixedDate(std::string pdf) {
  static const std::string date = "/CreationDate (D:", fixed = "20000101000000";
  const std::size_t at = pdf.find(date);
  if (at != std::string::npos) pdf.replace(at + date.size(), fixed.size(), fixed);
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
                    .pdf = WithFixedDate(ReadDrawing(folder.path() / "figure.pdf", figure.name))};
  drawn.page_svg = PageSvg(drawn.svg, figure.name);
  return drawn;
}

}  // namespace touchdown::report
