#include "scenarios/report/pad_sheet.h"

#include <cairo/cairo-pdf.h>
#include <cairo/cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <variant>

#include "models/angles.h"
#include "models/pad_outline.h"
#include "scenarios/report/cairo_bytes.h"

namespace touchdown::report {
namespace {

using models::LandingPad;

// Lengths on the page are in mm, with x to the right and y down.
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kMmPerMeter = 1000.0;
constexpr double kRuler_mm = 100.0;
constexpr double kMargin_mm = 6.0;
constexpr double kLegendHeight_mm = 24.0;
constexpr double kTextSize_mm = 3.2;
constexpr double kHairline_mm = 0.15;
constexpr double kLegendGray = 0.35;
/// Largest deviation of a drawn curve from the true curve.
constexpr double kTolerance_mm = 0.001;

struct Page {
  double width_mm = 0.0;
  double height_mm = 0.0;
  double legend_top_mm = 0.0;
  bool larger_than_sheet = false;
};

Page PageFor(const LandingPad& pad) {
  const double sheet_width_mm = kMmPerMeter * pad.sheet_width_m, sheet_height_mm = kMmPerMeter * pad.sheet_length_m;
  const double free_below_mm = 0.5 * sheet_height_mm - kMmPerMeter * pad.outer_radius_m;
  const bool high_enough = free_below_mm >= kLegendHeight_mm + 2.0 * kMargin_mm;
  const bool wide_enough = sheet_width_mm >= kRuler_mm + 2.0 * kMargin_mm;
  if (high_enough && wide_enough) {
    return {sheet_width_mm, sheet_height_mm, sheet_height_mm - kLegendHeight_mm - kMargin_mm, false};
  }
  return {std::max(sheet_width_mm, kRuler_mm + 2.0 * kMargin_mm), sheet_height_mm + kLegendHeight_mm + 2.0 * kMargin_mm,
          sheet_height_mm + kMargin_mm, true};
}

/// Draws the page, independent of the file format.
class Drawing {
 public:
  Drawing(const LandingPad& pad, const Page& page, cairo_surface_t* surface)
      : pad_(pad), page_(page), cairo_(cairo_create(surface), cairo_destroy) {
    cairo_scale(cairo(), kPointsPerMm, kPointsPerMm);
    cairo_set_tolerance(cairo(), kTolerance_mm * kPointsPerMm);
  }

  void Draw() {
    DrawPad();
    if (page_.larger_than_sheet) DrawCutLine();
    DrawLegend();
    cairo_show_page(cairo());
    if (cairo_status(cairo()) != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(std::string("cannot draw the pad: ") + cairo_status_to_string(cairo_status(cairo())));
    }
  }

 private:
  cairo_t* cairo() { return cairo_.get(); }
  double Mm(double length_m) const { return kMmPerMeter * length_m; }

  /// Fills the black shapes on the white page. All shapes form one path, so that no seam appears where two black shapes
  /// touch. White shapes have the opposite orientation and cut holes.
  void DrawPad() {
    cairo_save(cairo());
    const cairo_matrix_t page_from_W = {.xx = 0.0,
                                        .yx = -kMmPerMeter,
                                        .xy = -kMmPerMeter,
                                        .yy = 0.0,
                                        .x0 = 0.5 * page_.width_mm,
                                        .y0 = 0.5 * Mm(pad_.sheet_length_m)};
    cairo_transform(cairo(), &page_from_W);
    const models::PadOutline outline(pad_);
    for (const models::PadShape& shape : std::span(outline.shapes()).subspan<1>()) Add(shape);
    cairo_set_source_rgb(cairo(), 0.0, 0.0, 0.0);
    cairo_fill(cairo());
    cairo_restore(cairo());
  }

  /// Adds a shape to the path, in W.
  void Add(const models::PadShape& shape) {
    const bool is_black = shape.color == models::PadShape::Color::kBlack;
    cairo_new_sub_path(cairo());
    if (const auto* circle = std::get_if<models::Circle>(&shape.outline)) {
      const Eigen::Vector2d& center = circle->center_m;
      const auto arc = is_black ? cairo_arc : cairo_arc_negative;
      arc(cairo(), center.x(), center.y(), circle->radius_m, 0.0, (is_black ? 2.0 : -2.0) * models::kPi);
    } else {
      auto corners = std::get<models::Polygon>(shape.outline).corners_m;
      if (!is_black) std::reverse(corners.begin(), corners.end());
      for (const Eigen::Vector2d& corner : corners) cairo_line_to(cairo(), corner.x(), corner.y());
    }
    cairo_close_path(cairo());
  }

  void DrawCutLine() {
    cairo_save(cairo());
    const double dash_mm = 2.0;
    cairo_set_dash(cairo(), &dash_mm, 1, 0.0);
    SetPen();
    const double width = Mm(pad_.sheet_width_m);
    cairo_rectangle(cairo(), 0.5 * (page_.width_mm - width), 0.0, width, Mm(pad_.sheet_length_m));
    cairo_stroke(cairo());
    cairo_restore(cairo());
  }

  void DrawLegend() {
    SetPen();
    DrawRuler(page_.legend_top_mm + 4.0);
    Write(fmt::format("Print at 100 %. This ruler must measure {:g} mm.", kRuler_mm), page_.legend_top_mm + 14.0);
    Write(fmt::format(
              "Ring: outer radius {:g} mm, width {:g} mm. H: {:g} x {:g} mm, stroke {:g} mm. Sheet: {:g} x {:g} mm.",
              Mm(pad_.outer_radius_m), Mm(pad_.ring_width_m), Mm(pad_.h_height_m), Mm(pad_.h_width_m),
              Mm(pad_.h_stroke_m), Mm(pad_.sheet_length_m), Mm(pad_.sheet_width_m)),
          page_.legend_top_mm + 20.0);
  }

  void SetPen() {
    cairo_set_source_rgb(cairo(), kLegendGray, kLegendGray, kLegendGray);
    cairo_set_line_width(cairo(), kHairline_mm);
  }

  void DrawRuler(double y) {
    const double left = 0.5 * (page_.width_mm - kRuler_mm);
    cairo_move_to(cairo(), left, y);
    cairo_rel_line_to(cairo(), kRuler_mm, 0.0);
    for (int mm = 0; mm <= static_cast<int>(kRuler_mm); ++mm) {
      cairo_move_to(cairo(), left + mm, y);
      cairo_rel_line_to(cairo(), 0.0, mm % 10 == 0 ? -3.5 : mm % 5 == 0 ? -2.5 : -1.5);
    }
    cairo_stroke(cairo());
  }

  /// Draws centered text. Reduces the text size when the page is too narrow.
  void Write(const std::string& text, double baseline) {
    cairo_select_font_face(cairo(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo(), kTextSize_mm);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo(), text.c_str(), &extents);
    const double shrink = std::min(1.0, (page_.width_mm - 2.0 * kMargin_mm) / extents.x_advance);
    cairo_set_font_size(cairo(), shrink * kTextSize_mm);
    cairo_move_to(cairo(), 0.5 * (page_.width_mm - shrink * extents.x_advance), baseline);
    cairo_show_text(cairo(), text.c_str());
  }

  const LandingPad& pad_;
  const Page& page_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace

std::string PadSheet(const LandingPad& pad, SheetFormat format) {
  pad.Validate();
  const Page page = PageFor(pad);
  const auto create =
      format == SheetFormat::kPdf ? cairo_pdf_surface_create_for_stream : cairo_svg_surface_create_for_stream;
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      create(AppendBytes, &bytes, kPointsPerMm * page.width_mm, kPointsPerMm * page.height_mm), cairo_surface_destroy);
  if (format == SheetFormat::kPdf) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, kPadSheetSignature);
  }
  Drawing(pad, page, surface.get()).Draw();
  cairo_surface_finish(surface.get());
  if (format == SheetFormat::kSvg) bytes += fmt::format("<!-- {} -->\n", kPadSheetSignature);
  return bytes;
}

}  // namespace touchdown::report
