#include "estimator/paper/paper_options.h"

#include <array>
#include <string_view>

namespace touchdown::estimator::paper {
namespace {

constexpr std::array<std::string_view, 2> kContourPointNames = {"integer", "subpixel"};
constexpr std::array<std::string_view, 2> kVerifyNames = {"none", "template"};

}  // namespace

void Describe(models::ConfigVisitor& v, PaperOptions& c) {
  v.Choice({"contour_points",
            "Position of the edge points: integer uses the pixels of Canny's edges, subpixel refines them along the "
            "gradient."},
           c.contour_points, kContourPointNames);
  v.Choice(
      {"verify",
       "Verification of a ring and a letter as the pad: none accepts every pair, as published; template requires a "
       "match of the pad's artwork."},
      c.verify, kVerifyNames);
}

}  // namespace touchdown::estimator::paper
