#pragma once

#include <string>

namespace touchdown::report {

/// A figure as numbers and the way to draw them.
struct Figure {
  std::string name = {};     ///< Of its files: letters, digits and _.
  std::string title = {};    ///< "Fig. 6a: ..."
  std::string caption = {};  ///< What it shows, in HTML.
  std::string csv = {};      ///< The numbers, with a head line.
  std::string plot = {};     ///< gnuplot commands; the numbers are the file `data`.
  double width_cm = 17.0;
  double height_cm = 7.0;
};

struct DrawnFigure {
  std::string svg = {};
  std::string
      page_svg;  ///< A part of a page whose colors it takes by their CSS variables, so that it follows its theme.
  std::string pdf = {};
};

/// Draws by the program gnuplot (Debian: gnuplot-nox). The same figure gives the same SVG. Throws InputError when
/// gnuplot is not there, std::runtime_error with its words when it refuses the commands.
DrawnFigure Draw(const Figure& figure);

}  // namespace touchdown::report
