#include "sim/scene/artwork.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "models/angles.h"
#include "models/pad_outline.h"
#include "models/random_stream.h"

namespace touchdown::sim {
namespace {

using Kind = SceneItem::Kind;
using models::RandomStream;

constexpr int kShift = 6;

cv::Point Fixed(double x, double y) {
  return {static_cast<int>(std::lround(x * (1 << kShift))), static_cast<int>(std::lround(y * (1 << kShift)))};
}

/// Gray levels of an item's artwork, usually less black and less white than those of the pad.
struct Tones {
  explicit Tones(RandomStream& random) : paper(random.Uniform(175.0, kPaper)), ink(random.Uniform(15.0, 60.0)) {}
  double paper;
  double ink;
};

cv::Mat1b Blank(const SceneItem& item, double level) {
  constexpr double kTexelsPerMeter = 2000.0;
  const auto texels = [](double size_m) { return std::clamp(static_cast<int>(size_m * kTexelsPerMeter), 64, 1200); };
  return cv::Mat1b(texels(item.size_m.y()), texels(item.size_m.x()), cv::saturate_cast<std::uint8_t>(level));
}

void FillPolygon(cv::Mat1b& canvas, const std::vector<cv::Point2d>& corners, double level) {
  std::vector<cv::Point> fixed;
  for (const cv::Point2d& corner : corners) fixed.push_back(Fixed(corner.x, corner.y));
  cv::fillConvexPoly(canvas, fixed, cv::Scalar(level), cv::LINE_AA, kShift);
}

/// A ring that fills its sheet up to a margin.
cv::Mat1b PaintRing(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const double margin = random.Uniform(0.06, 0.2);
  const double a = canvas.cols * (0.5 - margin / 2), b = canvas.rows * (0.5 - margin / 2);
  const double inner = 1.0 - random.Uniform(0.10, 0.32);
  const cv::Point center = Fixed(0.5 * canvas.cols, 0.5 * canvas.rows);
  const auto axes = [&](double scale) { return cv::Size(Fixed(a * scale, b * scale)); };
  cv::ellipse(canvas, center, axes(1.0), 0, 0, 360, cv::Scalar(tones.ink), cv::FILLED, cv::LINE_AA, kShift);
  cv::ellipse(canvas, center, axes(inner), 0, 0, 360, cv::Scalar(tones.paper), cv::FILLED, cv::LINE_AA, kShift);
  return canvas;
}

/// A letter H whose long strokes run along the sheet's X, with random proportions.
cv::Mat1b PaintLetter(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const double margin = random.Uniform(0.12, 0.25);
  const double half_x = canvas.cols * (0.5 - margin / 2), half_y = canvas.rows * (0.5 - margin / 2);
  const double cx = 0.5 * canvas.cols, cy = 0.5 * canvas.rows;
  const double stroke = 2.0 * half_y * random.Uniform(0.18, 0.34);
  const auto bar = [&](double x0, double y0, double x1, double y1) {
    FillPolygon(canvas, {{cx + x0, cy + y0}, {cx + x1, cy + y0}, {cx + x1, cy + y1}, {cx + x0, cy + y1}}, tones.ink);
  };
  bar(-half_x, -half_y, half_x, -half_y + stroke);
  bar(-half_x, half_y - stroke, half_x, half_y);
  bar(-0.5 * stroke, -half_y, 0.5 * stroke, half_y);
  return canvas;
}

/// A solid rectangle on its sheet, with random proportions.
cv::Mat1b PaintRectangle(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const double x = canvas.cols * random.Uniform(0.06, 0.15), y = canvas.rows * random.Uniform(0.06, 0.25);
  const double right = canvas.cols - x, bottom = canvas.rows - y;
  FillPolygon(canvas, {{x, y}, {right, y}, {right, bottom}, {x, bottom}}, tones.ink);
  return canvas;
}

void WriteLines(cv::Mat1b& canvas, const cv::Rect& area, const Tones& tones, RandomStream& random) {
  static const std::string kGlyphs = "abcdefgijkmnprstuvwxyzABCEFGKLMNPRSTVWXYZ2345679&%$#?!=+";
  const double scale = random.Uniform(0.5, 1.6);
  const int font = random.Bernoulli(0.5) ? cv::FONT_HERSHEY_SIMPLEX : cv::FONT_HERSHEY_COMPLEX;
  const int thickness = random.UniformInt(1, 3);
  for (int y = area.y + static_cast<int>(30 * scale); y < area.br().y; y += static_cast<int>(36 * scale)) {
    std::string line;
    const int length = static_cast<int>(area.width * random.Uniform(0.6, 1.0) / (19 * scale));
    for (int i = 0; i < length; ++i) {
      const bool space = random.Bernoulli(0.16);
      line += space ? ' ' : kGlyphs[static_cast<std::size_t>(random.UniformInt(0, int(kGlyphs.size()) - 1))];
    }
    cv::putText(canvas(area), line, {0, y - area.y}, font, scale, cv::Scalar(tones.ink), thickness, cv::LINE_AA);
  }
}

cv::Mat1b PosterOfText(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const int margin = canvas.cols / 16;
  WriteLines(canvas, {margin, margin, canvas.cols - 2 * margin, canvas.rows - 2 * margin}, tones, random);
  return canvas;
}

cv::Mat1b PosterOfBlobs(const SceneItem& item, RandomStream& random) {
  cv::Mat1b canvas = Blank(item, random.Uniform(40.0, 220.0));
  for (int i = 0; i < 90; ++i) {
    const double x = random.Uniform(0.0, canvas.cols), y = random.Uniform(0.0, canvas.rows);
    const double a = canvas.cols * random.Uniform(0.01, 0.10), b = a * random.Uniform(0.3, 1.0);
    const double angle_deg = random.Uniform(0.0, 180.0), level = random.Uniform(15.0, 235.0);
    cv::ellipse(canvas, Fixed(x, y), cv::Size(Fixed(a, b)), angle_deg, 0, 360, cv::Scalar(level), cv::FILLED,
                cv::LINE_AA, kShift);
  }
  return canvas;
}

cv::Mat1b PosterOfLines(const SceneItem& item, RandomStream& random) {
  cv::Mat1b canvas = Blank(item, random.Uniform(120.0, 220.0));
  for (int i = 0; i < 60; ++i) {
    const auto point = [&] { return cv::Point{random.UniformInt(0, canvas.cols), random.UniformInt(0, canvas.rows)}; };
    const cv::Point from = point(), to = point();
    const double level = random.Uniform(15.0, 235.0);
    const int thickness = random.UniformInt(1, canvas.cols / 40 + 2);
    cv::line(canvas, from, to, cv::Scalar(level), thickness, cv::LINE_AA);
  }
  return canvas;
}

cv::Mat1b PosterOfChecks(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const int columns = random.UniformInt(4, 12);
  const double side = static_cast<double>(canvas.cols) / columns;
  for (int j = 0; j * side < canvas.rows; ++j) {
    for (int i = j % 2; i < columns; i += 2) {
      const double x = i * side, y = j * side;
      FillPolygon(canvas, {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, tones.ink);
    }
  }
  return canvas;
}

/// Noise with a falling spectrum and a stretched histogram, which responds to a threshold like a photograph.
cv::Mat1b PosterOfPhoto(const SceneItem& item, RandomStream& random) {
  cv::Mat1b canvas = Blank(item, 0.0);
  cv::Mat1f sum = cv::Mat1f::zeros(canvas.size());
  float gain = 1.0f;
  for (int cells = 4; cells <= 128; cells *= 2, gain *= 0.62f) {
    cv::Mat1f octave(cells, cells), stretched;
    for (float& value : octave) value = gain * static_cast<float>(random.Uniform(-1.0, 1.0));
    cv::resize(octave, stretched, canvas.size(), 0, 0, cv::INTER_CUBIC);
    sum += stretched;
  }
  cv::Mat1f stretched;
  cv::normalize(sum, stretched, -30.0, 285.0, cv::NORM_MINMAX);
  stretched.convertTo(canvas, CV_8U);
  return cv::Mat1b(cv::max(15, cv::min(235, canvas)));
}

/// A page of a magazine: a title, a photograph and text on a gradient.
cv::Mat1b PosterOfPage(const SceneItem& item, RandomStream& random) {
  const Tones tones(random);
  cv::Mat1b canvas = Blank(item, tones.paper);
  const double fade = random.Uniform(-70.0, 0.0);
  for (int v = 0; v < canvas.rows; ++v) {
    canvas.row(v).setTo(tones.paper + fade * v / canvas.rows);
  }
  const int w = canvas.cols, h = canvas.rows;
  cv::rectangle(canvas, cv::Rect(w / 16, h / 16, w * 7 / 8, h / 8), cv::Scalar(random.Uniform(15.0, 120.0)),
                cv::FILLED);
  cv::putText(canvas, random.Bernoulli(0.5) ? "SURVEY" : "AVIATE", {w / 12, h / 16 + h / 10}, cv::FONT_HERSHEY_TRIPLEX,
              h / 350.0, cv::Scalar(tones.paper), 2, cv::LINE_AA);
  const bool left = random.Bernoulli(0.5);
  const cv::Rect photo_area(left ? w / 16 : w / 2, h / 4, w * 7 / 16, h * 5 / 16);
  const cv::Rect text(left ? w * 17 / 32 : w / 16, h / 4, w * 13 / 32, h * 5 / 16);
  cv::Mat1b photo;
  cv::resize(PosterOfPhoto(item, random), photo, photo_area.size(), 0, 0, cv::INTER_AREA);
  photo.copyTo(canvas(photo_area));
  WriteLines(canvas, text, tones, random);
  WriteLines(canvas, {w / 16, h * 5 / 8, w * 7 / 8, h * 5 / 16}, tones, random);
  return canvas;
}

cv::Mat1b PaintPoster(const SceneItem& item, RandomStream& random) {
  constexpr std::array kPosters{PosterOfText,  PosterOfBlobs, PosterOfLines, PosterOfChecks,
                                PosterOfPhoto, PosterOfPage,  PosterOfPage};
  return kPosters[static_cast<std::size_t>(random.UniformInt(0, int(kPosters.size()) - 1))](item, random);
}

/// Surface of a stone, with speckles.
cv::Mat1b PaintStone(const SceneItem& item, int face_width) {
  RandomStream random(item.texture_seed, "print");
  const double base = random.Uniform(70.0, 190.0);
  cv::Mat1b faces(6 * face_width, face_width);
  for (std::uint8_t& texel : faces) texel = cv::saturate_cast<std::uint8_t>(base + random.Uniform(-40.0, 40.0));
  cv::GaussianBlur(faces, faces, {}, 1.2);
  return faces;
}

}  // namespace

cv::Mat1b PaintPad(const models::LandingPad& pad, int width, int height) {
  constexpr int kSide = 5;
  const models::PadOutline outline(pad);
  const auto black = [&](double column, double row) {
    return outline.IsBlack({(column / width - 0.5) * pad.sheet_length_m, (0.5 - row / height) * pad.sheet_width_m});
  };
  cv::Mat1b at_corners(height + 1, width + 1);
  for (int j = 0; j <= height; ++j) {
    for (int i = 0; i <= width; ++i) at_corners(j, i) = black(i, j) ? 1 : 0;
  }
  cv::Mat1b artwork(height, width);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const int corners = at_corners(j, i) + at_corners(j, i + 1) + at_corners(j + 1, i) + at_corners(j + 1, i + 1);
      double coverage = corners / 4.0;
      if (corners % 4 != 0) {
        int hits = 0;
        for (int n = 0; n < kSide * kSide; ++n) {
          const int across = n % kSide, down = n / kSide;
          hits += black(i + (across + 0.5) / kSide, j + (down + 0.5) / kSide) ? 1 : 0;
        }
        coverage = static_cast<double>(hits) / (kSide * kSide);
      }
      artwork(j, i) = cv::saturate_cast<std::uint8_t>(kPaper + coverage * (kInk - kPaper));
    }
  }
  return artwork;
}

cv::Mat1b PaintSheet(const SceneItem& item, int width, int height) {
  RandomStream random(item.texture_seed, "print");
  cv::Mat1b canvas;
  switch (item.kind) {
    case Kind::kRing:
      canvas = PaintRing(item, random);
      break;
    case Kind::kLetterH:
      canvas = PaintLetter(item, random);
      break;
    case Kind::kRectangle:
      canvas = PaintRectangle(item, random);
      break;
    case Kind::kPoster:
      canvas = PaintPoster(item, random);
      break;
    default:
      throw std::logic_error("a solid item has no sheet");
  }
  cv::Mat1b artwork;
  cv::resize(canvas, artwork, {width, height}, 0, 0, cv::INTER_AREA);
  return artwork;
}

cv::Mat1b PaintSolid(const SceneItem& item, int face_width) {
  if (item.kind == Kind::kStone) return PaintStone(item, face_width);
  RandomStream random(item.texture_seed, "print");
  const double base = random.Uniform(40.0, 200.0);
  const bool label = random.Bernoulli(0.6);
  cv::Mat1b faces(6 * face_width, face_width);
  for (int face = 0; face < 6; ++face) {
    cv::Mat1b canvas = faces.rowRange(face * face_width, (face + 1) * face_width);
    for (std::uint8_t& texel : canvas) texel = cv::saturate_cast<std::uint8_t>(base + random.Uniform(-14.0, 14.0));
    const double band = face_width * random.Uniform(0.15, 0.85);
    cv::rectangle(canvas, cv::Rect(0, static_cast<int>(band), face_width, face_width / 8), cv::Scalar(0.6 * base),
                  cv::FILLED);
    if (label) {
      const int side = face_width / 3, x = random.UniformInt(0, face_width - side);
      cv::rectangle(canvas, cv::Rect(x, face_width / 4, side, side * 2 / 3), cv::Scalar(220), cv::FILLED);
      cv::putText(canvas, "KG 7", {x + 2, face_width / 4 + side / 3}, cv::FONT_HERSHEY_SIMPLEX, 0.35, cv::Scalar(30), 1,
                  cv::LINE_AA);
    }
  }
  return faces;
}

}  // namespace touchdown::sim
