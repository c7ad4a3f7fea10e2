#pragma once

#include <string>

namespace touchdown::report {

/// Data of a figure and the gnuplot commands that draw it.
struct Figure {
  std::string name = {};     ///< Base name of its files: letters, digits and _.
  std::string title = {};    ///< "Fig. 6a: ..."
  std::string caption = {};  ///< Description of what the figure shows, as HTML.
  std::string csv = {};      ///< Data, with a header line.
  std::string plot = {};     ///< gnuplot commands. The variable `data` is the name of the CSV file.
  double width_cm = 17.0;
  double height_cm = 7.0;
};

struct DrawnFigure {
  std::string svg = {};
  /// SVG element to embed in an HTML page. Its colors are the CSS variables of the page, so that it follows the theme.
  std::string page_svg = {};
  std::string pdf = {};
};

/// Draws a figure with the program gnuplot (Debian: gnuplot-nox). Equal figures give equal files. Throws InputError
/// when gnuplot is not installed, std::runtime_error with the stderr output of gnuplot when it rejects the commands.
DrawnFigure Draw(const Figure& figure);

}  // namespace touchdown::report
