#include "tests/support/photo_artwork.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <opencv2/imgproc.hpp>

#include "models/angles.h"

namespace touchdown::tests {
namespace {

using models::kPi;
using models::LandingPad;
using models::RandomStream;

constexpr int kShift = 4;  ///< Number of fractional bits of coordinates in OpenCV's drawing functions.

cv::Point Fixed(const cv::Point2d& p) {
  return {static_cast<int>(std::lround(p.x * (1 << kShift))), static_cast<int>(std::lround(p.y * (1 << kShift)))};
}

cv::Point2d Rotated(double x, double y, double yaw) {
  return {std::cos(yaw) * x - std::sin(yaw) * y, std::sin(yaw) * x + std::cos(yaw) * y};
}

/// The H of the pad, scaled by `scale`, rotated by `yaw` and moved to (x, y).
void PrintH(const LandingPad& pad, double scale, double x, double y, double yaw, Artwork& art, bool bar = true) {
  const double side = 0.5 * (pad.h_width_m - pad.h_stroke_m) * scale;
  for (const double s : {-1.0, 1.0}) {
    const cv::Point2d c = Rotated(0.0, s * side, yaw);
    art.FillBox(x + c.x, y + c.y, pad.h_height_m * scale, pad.h_stroke_m * scale, yaw);
  }
  if (bar) art.FillBox(x, y, pad.h_stroke_m * scale, pad.h_width_m * scale, yaw);
}

void PrintRing(const LandingPad& pad, Artwork& art) {
  art.FillRing(0.0, 0.0, pad.outer_radius_m, pad.inner_radius_m());
}

using Printer = std::function<void(const LandingPad&, RandomStream&, Artwork&)>;

/// Ring with a letter of straight strokes. Endpoints are relative to the box of the H.
Printer Strokes(std::vector<std::array<double, 4>> lines) {
  return [lines = std::move(lines)](const LandingPad& pad, RandomStream& random, Artwork& art) {
    PrintRing(pad, art);
    const double scale = random.Uniform(0.85, 1.15), stroke = pad.h_stroke_m * random.Uniform(0.7, 1.2);
    const double x = 0.5 * scale * (pad.h_height_m - stroke), y = 0.5 * scale * (pad.h_width_m - stroke);
    for (const auto& [x1, y1, x2, y2] : lines) art.Line(x * x1, y * y1, x * x2, y * y2, stroke);
  };
}

Printer Glyph(std::string text) {
  return [text = std::move(text)](const LandingPad& pad, RandomStream& random, Artwork& art) {
    PrintRing(pad, art);
    art.Text(text, 0.0, 0.0, pad.h_height_m * random.Uniform(0.8, 1.1), random.Uniform(0.12, 0.25));
  };
}

/// Ring with an H of the wrong size or position.
Printer MisplacedH(double scale_low, double scale_high, double offset_low, double offset_high) {
  return [=](const LandingPad& pad, RandomStream& random, Artwork& art) {
    PrintRing(pad, art);
    const double direction = random.Uniform(-kPi, kPi);
    const double offset = pad.outer_radius_m * random.Uniform(offset_low, offset_high);
    PrintH(pad, random.Uniform(scale_low, scale_high), offset * std::cos(direction), offset * std::sin(direction),
           random.Uniform(-kPi, kPi), art);
  };
}

void PrintFrame(int corners, const LandingPad& pad, double yaw, Artwork& art) {
  std::vector<cv::Point2d> outer, inner;
  for (int i = 0; i < corners; ++i) {
    const double angle = yaw + 2.0 * kPi * i / corners;
    const double scale = corners == 3 ? 1.15 : 1.0;
    outer.push_back(scale * pad.outer_radius_m * cv::Point2d(std::cos(angle), std::sin(angle)));
    inner.push_back((scale * pad.outer_radius_m - pad.ring_width_m / std::cos(kPi / corners)) *
                    cv::Point2d(std::cos(angle), std::sin(angle)));
  }
  art.FillPolygon(outer);
  art.FillPolygon(inner, false);
}

Printer FramedH(int corners, double scale) {
  return [=](const LandingPad& pad, RandomStream& random, Artwork& art) {
    PrintFrame(corners, pad, random.Uniform(-kPi, kPi), art);
    PrintH(pad, scale, 0.0, 0.0, random.Uniform(-kPi, kPi), art);
  };
}

void PrintArrow(const LandingPad& pad, RandomStream&, Artwork& art) {
  PrintRing(pad, art);
  const double a = 0.5 * pad.h_height_m, b = 0.5 * pad.h_width_m;
  art.Line(-a, 0.0, 0.4 * a, 0.0, pad.h_stroke_m);
  art.FillPolygon({{a, 0.0}, {0.2 * a, b}, {0.2 * a, -b}});
}

void PrintBullsEye(const LandingPad& pad, RandomStream& random, Artwork& art) {
  const double step = pad.outer_radius_m / random.UniformInt(3, 5);
  for (double r = pad.outer_radius_m; r > 0.6 * step; r -= step) art.FillRing(0.0, 0.0, r, r - 0.5 * step);
}

void PrintManhole(const LandingPad& pad, RandomStream& random, Artwork& art) {
  PrintRing(pad, art);
  const int cells = random.UniformInt(3, 7);
  const double step = 2.0 * pad.inner_radius_m() / cells;
  for (int i = -cells; i <= cells; ++i) {
    for (int j = -cells; j <= cells; ++j) {
      const double x = i * step, y = (j + 0.5 * (i & 1)) * step;
      if (std::hypot(x, y) < pad.inner_radius_m() - 0.5 * step)
        art.FillBox(x, y, 0.6 * step, 0.25 * step, 0.8 * (j & 1));
    }
  }
}

void PrintCode(const LandingPad& pad, RandomStream& random, Artwork& art) {
  const double side = 0.8 * pad.outer_radius_m;
  const int cells = random.UniformInt(8, 21);
  const double step = 2.0 * side / cells;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      if (random.Bernoulli(0.5))
        art.FillBox(-side + (i + 0.5) * step, -side + (j + 0.5) * step, step * 1.02, step * 1.02);
    }
  }
}

void PrintTextPage(const LandingPad& pad, RandomStream& random, Artwork& art) {
  static const std::vector<std::string> kWords = {"HEIGHT", "THE",  "hover", "with", "H",
                                                  "O",      "HIGH", "pad",   "OHO",  "Land"};
  const double line = pad.sheet_length_m / random.UniformInt(8, 22);
  for (double x = 0.5 * pad.sheet_length_m - line; x > -0.5 * pad.sheet_length_m + line; x -= line) {
    for (double y = 0.45 * pad.sheet_width_m; y > -0.35 * pad.sheet_width_m; y -= line * random.Uniform(2.2, 3.5)) {
      const int word = random.UniformInt(0, static_cast<int>(kWords.size()) - 1);
      art.Text(kWords[static_cast<std::size_t>(word)], x, y, 0.5 * line, 0.16);
    }
  }
}

void PrintLetters(const LandingPad& pad, RandomStream& random, Artwork& art) {
  static const std::string kLetters = "AHNMKRBEXOQC0819H";
  for (int i = 0; i < 3; ++i) {
    const std::string letter(1, kLetters[static_cast<std::size_t>(random.UniformInt(0, 16))]);
    art.Text(letter, (1 - i) * 0.3 * pad.sheet_length_m, random.Uniform(-0.2, 0.2) * pad.sheet_width_m,
             0.2 * pad.sheet_length_m, random.Uniform(0.1, 0.25), random.Uniform(-0.4, 0.4));
  }
}

const std::map<std::string, Printer>& Printers() {
  static const std::map<std::string, Printer> printers = {
      {"X in ring", Strokes({{{1, 1, -1, -1}}, {{1, -1, -1, 1}}})},
      {"+ in ring", Strokes({{{1, 0, -1, 0}}, {{0, 1.6, 0, -1.6}}})},
      {"T in ring", Strokes({{{1, 1, 1, -1}}, {{1, 0, -1, 0}}})},
      {"A in ring", Strokes({{{-1, 1, 1, 0.15}}, {{-1, -1, 1, -0.15}}, {{-0.3, 0.7, -0.3, -0.7}}})},
      {"N in ring", Strokes({{{-1, 1, 1, 1}}, {{1, 1, -1, -1}}, {{-1, -1, 1, -1}}})},
      {"I in ring", Strokes({{{1, 0, -1, 0}}})},
      {"II in ring", Strokes({{{1, 1, -1, 1}}, {{1, -1, -1, -1}}})},
      {"E in ring", Strokes({{{1, 1, -1, 1}}, {{1, 1, 1, -1}}, {{0, 1, 0, -1}}, {{-1, 1, -1, -1}}})},
      {"U in ring", Strokes({{{1, 1, -1, 1}}, {{1, -1, -1, -1}}, {{-1, 1, -1, -1}}})},
      {"box in ring", Strokes({{{1, 1, -1, 1}}, {{1, -1, -1, -1}}, {{-1, 1, -1, -1}}, {{1, 1, 1, -1}}})},
      {"triangle in ring", Strokes({{{-1, 1, 1, 0}}, {{-1, -1, 1, 0}}, {{-1, 1, -1, -1}}})},
      {"bars in ring", Strokes({{{1, 1, 1, -1}}, {{0, 1, 0, -1}}, {{-1, 1, -1, -1}}})},
      {"M in ring", Strokes({{{-1, 1, 1, 1}}, {{1, 1, -0.2, 0}}, {{-0.2, 0, 1, -1}}, {{1, -1, -1, -1}}})},
      {"K in ring", Strokes({{{-1, 1, 1, 1}}, {{0, 1, 1, -1}}, {{0, 1, -1, -1}}})},
      {"B in ring", Glyph("B")},
      {"8 in ring", Glyph("8")},
      {"0 in ring", Glyph("0")},
      {"P in ring", Glyph("P")},
      {"R in ring", Glyph("R")},
      {"arrow in ring", PrintArrow},
      {"lone ring", [](const LandingPad& pad, RandomStream&, Artwork& art) { PrintRing(pad, art); }},
      {"lone H", [](const LandingPad& pad, RandomStream&, Artwork& art) { PrintH(pad, 1.0, 0.0, 0.0, 0.0, art); }},
      {"bull's eye", PrintBullsEye},
      {"ring with tiny H", MisplacedH(0.25, 0.45, 0.0, 0.1)},
      {"ring with H off center", MisplacedH(0.55, 0.65, 0.45, 0.6)},
      {"ring with H outside", MisplacedH(0.4, 0.5, 1.35, 1.5)},
      {"ring with huge H", MisplacedH(1.9, 2.2, 0.0, 0.05)},
      {"H in square", FramedH(4, 0.8)},
      {"H in triangle", FramedH(3, 0.55)},
      {"manhole", PrintManhole},
      {"code", PrintCode},
      {"text page", PrintTextPage},
      {"letters", PrintLetters},
  };
  return printers;
}

}  // namespace

Artwork::Artwork(const LandingPad& pad, double px_per_meter) : px_per_m(px_per_meter) {
  const auto side = [&](double length_m) { return static_cast<int>(std::lround(length_m * px_per_m)); };
  ink = cv::Mat1b::zeros(side(pad.sheet_length_m), side(pad.sheet_width_m));
}

cv::Point2d Artwork::At(double x_m, double y_m) const {
  return {0.5 * (ink.cols - 1) - y_m * px_per_m, 0.5 * (ink.rows - 1) - x_m * px_per_m};
}

void Artwork::FillPolygon(const std::vector<cv::Point2d>& corners_m, bool black) {
  std::vector<cv::Point> corners;
  for (const cv::Point2d& corner : corners_m) corners.push_back(Fixed(At(corner.x, corner.y)));
  cv::fillPoly(ink, corners, cv::Scalar(black ? 255 : 0), cv::LINE_AA, kShift);
}

void Artwork::FillBox(double x_m, double y_m, double size_x_m, double size_y_m, double yaw) {
  std::vector<cv::Point2d> corners;
  for (const auto& [sx, sy] : {std::pair(0.5, 0.5), {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 0.5}}) {
    corners.push_back(cv::Point2d(x_m, y_m) + Rotated(sx * size_x_m, sy * size_y_m, yaw));
  }
  FillPolygon(corners);
}

void Artwork::FillRing(double x_m, double y_m, double outer_m, double inner_m) {
  const auto fixed = [&](double length_m) {
    return static_cast<int>(std::lround(length_m * px_per_m * (1 << kShift)));
  };
  cv::Mat1b ring = cv::Mat1b::zeros(ink.size());
  const cv::Point center = Fixed(At(x_m, y_m));
  cv::circle(ring, center, fixed(outer_m), cv::Scalar(255), cv::FILLED, cv::LINE_AA, kShift);
  cv::circle(ring, center, fixed(inner_m), cv::Scalar(0), cv::FILLED, cv::LINE_AA, kShift);
  ink = cv::max(ink, ring);
}

void Artwork::Line(double x1_m, double y1_m, double x2_m, double y2_m, double width_m) {
  const double length = std::hypot(x2_m - x1_m, y2_m - y1_m);
  FillBox(0.5 * (x1_m + x2_m), 0.5 * (y1_m + y2_m), length + width_m, width_m, std::atan2(y2_m - y1_m, x2_m - x1_m));
}

void Artwork::Text(const std::string& text, double x_m, double y_m, double height_m, double stroke_fraction,
                   double yaw) {
  constexpr double kFontHeight = 21.0;  // Height of a capital letter at scale 1, px.
  const double height = height_m * px_per_m, scale = height / kFontHeight;
  const int thickness = std::max(1, static_cast<int>(std::lround(stroke_fraction * height)));
  int below = 0;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, &below);
  const cv::Point2d center = At(x_m, y_m);
  cv::Mat1b layer = cv::Mat1b::zeros(ink.size());
  const cv::Point origin(static_cast<int>(center.x) - size.width / 2, static_cast<int>(center.y) + size.height / 2);
  cv::putText(layer, text, origin, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255), thickness, cv::LINE_AA);
  if (yaw != 0.0) {
    const cv::Mat rotation = cv::getRotationMatrix2D(cv::Point2f(center), models::RadToDeg(yaw), 1.0);
    cv::warpAffine(layer, layer, rotation, layer.size());
  }
  ink = cv::max(ink, layer);
}

LandingPad DrawAnyPad(RandomStream& random) {
  LandingPad pad;
  if (random.Bernoulli(0.25)) return pad;
  const bool thin = random.Bernoulli(0.3), small = random.Bernoulli(0.3);
  pad.ring_width_m = pad.outer_radius_m * (thin ? random.Uniform(0.05, 0.10) : random.Uniform(0.10, 0.28));
  const double diagonal =
      2.0 * pad.inner_radius_m() * (small ? random.Uniform(0.38, 0.55) : random.Uniform(0.55, 0.85));
  const double aspect = random.Uniform(0.45, 0.85);
  pad.h_height_m = diagonal / std::hypot(1.0, aspect);
  pad.h_width_m = aspect * pad.h_height_m;
  pad.h_stroke_m = pad.h_width_m * random.Uniform(0.15, 0.32);
  const double size = random.Uniform(0.3, 3.0);
  for (double* length : {&pad.outer_radius_m, &pad.ring_width_m, &pad.h_height_m, &pad.h_width_m, &pad.h_stroke_m,
                         &pad.sheet_length_m, &pad.sheet_width_m}) {
    *length *= size;
  }
  return pad;
}

void PrintPad(const LandingPad& pad, Artwork& art) {
  PrintRing(pad, art);
  PrintH(pad, 1.0, 0.0, 0.0, 0.0, art);
}

const std::vector<std::string>& MarkingKinds() {
  static const std::vector<std::string> kinds = {"dots", "text", "arrow", "logo", "ticks", "cross-hair"};
  return kinds;
}

void PrintMarkings(const LandingPad& pad, const std::string& kind, RandomStream& random, Artwork& art) {
  // Width of the white area between H and ring, beside and above the H.
  const double inner = pad.inner_radius_m(), half_width = 0.5 * pad.h_width_m;
  const double gap = inner - half_width, middle = half_width + 0.5 * gap;
  const double end_gap = inner - 0.5 * pad.h_height_m, end = 0.5 * pad.h_height_m + 0.5 * end_gap;
  if (kind == "dots") {
    const double radius = random.Uniform(0.08, 0.22) * gap;
    const double angle = random.Uniform(0.5, 0.9), reach = std::hypot(0.5 * pad.h_height_m, half_width);
    const double place = std::min(std::max(middle, 0.5 * (reach + inner)), inner - 1.6 * radius);
    for (const double a : {angle, kPi - angle, kPi + angle, -angle}) {
      if (random.Bernoulli(0.75))
        art.FillRing(place * std::cos(a), place * std::sin(a), std::min(radius, 0.3 * (inner - reach)), 0.0);
    }
    art.FillRing(0.0, middle, radius, 0.0);
  } else if (kind == "text") {
    static const std::vector<std::string> kTexts = {"A1", "07", "PAD", "LAND", "12", "N", "B"};
    const auto& text = kTexts[static_cast<std::size_t>(random.UniformInt(0, 6))];
    art.Text(text, random.Uniform(-0.2, 0.2) * pad.h_height_m, random.Bernoulli(0.5) ? middle : -middle,
             random.Uniform(0.5, 0.9) * gap / static_cast<double>(text.size()), 0.16);
  } else if (kind == "arrow") {
    const double s = 0.3 * end_gap;
    art.FillPolygon({{end + s, 0.0}, {end - s, 1.2 * s}, {end - s, -1.2 * s}});
  } else if (kind == "logo") {
    const double s = random.Uniform(0.15, 0.3) * gap;
    for (const double y : {middle, -middle}) {
      const int corners = random.UniformInt(3, 6);
      std::vector<cv::Point2d> star;
      for (int i = 0; i < 2 * corners; ++i) {
        const double r = (i & 1) != 0 ? s : 0.5 * s, a = kPi * i / corners;
        star.emplace_back(r * std::cos(a), y + r * std::sin(a));
      }
      art.FillPolygon(star);
      if (random.Bernoulli(0.4)) break;
    }
  } else if (kind == "ticks") {
    const double length = 0.25 * std::min(gap, end_gap), width = 0.35 * length;
    for (int i = 0; i < 4; ++i) {
      const double a = i * kPi / 2.0, r = inner - 0.9 * length;
      art.FillBox(r * std::cos(a), r * std::sin(a), length, width, a);
    }
  } else {  // Crosshair that touches neither H nor ring.
    const double width = 0.12 * std::min(gap, end_gap);
    for (const double s : {-1.0, 1.0}) {
      art.FillBox(0.0, s * middle, width, 0.6 * gap);
      art.FillBox(s * end, 0.0, 0.6 * end_gap, width);
    }
  }
}

const std::vector<std::string>& DistractorKinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> result = {"floor desk", "floor cups", "floor tiles", "floor page"};
    for (const auto& [kind, unused] : Printers()) result.push_back(kind);
    return result;
  }();
  return kinds;
}

void PrintDistractor(const LandingPad& pad, const std::string& kind, RandomStream& random, Artwork& art) {
  const auto printer = Printers().find(kind);
  if (printer != Printers().end()) printer->second(pad, random, art);
}

}  // namespace touchdown::tests
