#include "estimator/paper/paper_options.h"

#include <array>
#include <string_view>

namespace touchdown::estimator::paper {
namespace {

constexpr std::array<std::string_view, 2> kContourPointNames = {"integer", "subpixel"};
constexpr std::array<std::string_view, 2> kVerifyNames = {"none", "template"};

}  // namespace

void Describe(models::ConfigVisitor& v, PaperOptions& c) {
  v.Choice({"contour_points", "Edge points: the pixels of Canny's edges, or their subpixel positions."},
           c.contour_points, kContourPointNames);
  v.Choice({"verify",
            "Verification of a ring and an H that may be the pad: none, as published, or a template match of the pad's "
            "artwork."},
           c.verify, kVerifyNames);
}

}  // namespace touchdown::estimator::paper
