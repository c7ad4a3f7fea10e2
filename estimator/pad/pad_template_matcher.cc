#include "estimator/pad/pad_template_matcher.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "models/angles.h"
#include "models/bilinear.h"
#include "models/error.h"
#include "models/order_statistic.h"

namespace touchdown::estimator::pad {
namespace {

using Eigen::Vector2d;

constexpr int kCells = RectifiedDisc::kCells;
constexpr int kTexels = 256;
constexpr double kBlurred = 0.03;        // Standard deviation, in inner radii.
constexpr double kFarthestOffset = 0.1;  // In inner radii.
constexpr double kLargestScale = 1.12;

float Quantile(const std::vector<float>& values, double share) {
  return models::OrderStatistic(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// Interpolated bilinearly; nullopt outside the image.
std::optional<float> GrayAt(const models::ImageView& image, const Vector2d& pixel) {
  if (!models::IsBetweenPixels(image, pixel)) return std::nullopt;
  return models::BilinearGray<float>(image, pixel);
}

/// What is printed within the ring.
Cells DrawPrint(const models::LandingPad& pad, const models::PadOutline& outline) {
  constexpr int kSamples = 3;
  Cells print(kTexels, kTexels);
  const double step = 2.0 * pad.inner_radius_m() / (kTexels * kSamples);
  for (int row = 0; row < kTexels; ++row) {
    for (int column = 0; column < kTexels; ++column) {
      int black = 0;
      for (int sample = 0; sample < kSamples * kSamples; ++sample) {
        const Vector2d p_W(step * (kSamples * column + sample % kSamples + 0.5) - pad.inner_radius_m(),
                           step * (kSamples * row + sample / kSamples + 0.5) - pad.inner_radius_m());
        black += p_W.norm() < pad.inner_radius_m() && outline.IsBlack(p_W);
      }
      print(row, column) = static_cast<float>(black) / (kSamples * kSamples);
    }
  }
  return print;
}

Cells Smoothed(const Cells& print, double sigma) {
  Cells smoothed(kTexels, kTexels);
  const cv::Mat1f source(kTexels, kTexels, const_cast<float*>(print.data()));
  cv::Mat1f target(kTexels, kTexels, smoothed.data());
  cv::GaussianBlur(source, target, {}, sigma * kTexels / 2.0, 0.0, cv::BORDER_CONSTANT);
  return smoothed;
}

double LetterReach(const models::LandingPad& pad) { return 0.5 * std::hypot(pad.h_height_m, pad.h_width_m); }

/// Whether nothing is printed on a circle around W's origin.
bool IsWhite(const models::PadOutline& outline, double radius_m) {
  constexpr int kDirections = 360;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * models::kPi * i / kDirections;
    if (outline.IsBlack(radius_m * Vector2d(std::cos(angle), std::sin(angle)))) return false;
  }
  return true;
}

/// Standard deviation, in inner radii, of a blur that leaves the middle of a stroke black.
double Sharpness(const models::LandingPad& pad) {
  constexpr double kUsual = 0.012, kOfStroke = 0.15;
  return std::min(kUsual, kOfStroke * pad.h_stroke_m / pad.inner_radius_m());
}

/// How far from the edges of an H its parts are looked at, m.
double EdgeMargin(const models::LandingPad& pad, const models::PadOutline& outline, double cell_m) {
  const double narrowest_m = std::min(pad.h_stroke_m, models::NarrowestPart(outline.letter()));
  return std::min(0.25 * narrowest_m, 0.1 * pad.h_stroke_m + 0.5 * cell_m);
}

/// The parts of an H, each of which another letter may lack; of a rectangle its four corners stand for the strokes'
/// ends, and the rest for the bar.
enum Part { kBar, kFirstStroke, kFirstBetween = kFirstStroke + 4, kBeside = kFirstBetween + 2, kParts };

/// The part on which a point lies at least `margin_m` away from the edges of the letter; nullopt nearer to them, and
/// where bar and strokes meet.
std::optional<int> PartAt(const models::LandingPad& pad, const models::PadOutline& outline, double margin_m,
                          const Vector2d& p_W) {
  const Vector2d p = p_W.cwiseAbs(), half_size = 0.5 * Vector2d(pad.h_height_m, pad.h_width_m);
  const auto is_in_box = [&](double grown_by_m) { return (p.array() < half_size.array() + grown_by_m).all(); };
  if (!is_in_box(margin_m)) return is_in_box(pad.h_stroke_m) ? std::optional<int>(kBeside) : std::nullopt;
  if (!is_in_box(0.0) || outline.DistanceFromLetter(p_W) <= margin_m) return std::nullopt;
  if (!outline.IsLetter(p_W)) return kFirstBetween + (p_W.x() > 0.0 ? 1 : 0);
  const int stroke_end = kFirstStroke + (p_W.x() > 0.0 ? 1 : 0) + (p_W.y() > 0.0 ? 2 : 0);
  if (pad.letter() == models::PadLetter::kRectangle) {
    constexpr double kCorner = 0.7;  // Of the way from the middle. An ellipse of the same area lacks half of it.
    return (p - kCorner * half_size).minCoeff() > 0.0 ? stroke_end : kBar;
  }
  if (p.y() < half_size.y() - pad.h_stroke_m) return kBar;
  return p.x() > 0.5 * pad.h_stroke_m ? std::optional(stroke_end) : std::nullopt;
}

}  // namespace

Vector2d TemplateWarp::OnPlane(const Vector2d& p_W) const {
  return offset_m + Eigen::Rotation2Dd(angle) * p_W.cwiseProduct(scale);
}

Vector2d TemplateWarp::OnTemplate(const Vector2d& p_plane) const {
  return (Eigen::Rotation2Dd(-angle) * (p_plane - offset_m)).cwiseQuotient(scale);
}

void TemplateMatcherConfig::Validate() const {
  for (const double share : {least_ring, least_between_strokes, least_bar, least_rectangle, least_stroke, least_strokes,
                             least_beside, least_contrast}) {
    if (!(share > 0.0 && share <= 1.0)) throw InputError("a print's least shares must be within (0, 1]");
  }
}

PadTemplateMatcher::PadTemplateMatcher(const models::LandingPad& pad, const TemplateMatcherConfig& config)
    : pad_(pad),
      outline_(pad),
      config_(config),
      reach_m_(std::min(0.98 * pad.inner_radius_m(), 1.15 * LetterReach(pad) + kFarthestOffset * pad.inner_radius_m())),
      white_m_(std::max(0.5 * (LetterReach(pad) + pad.inner_radius_m()), 0.85 * pad.inner_radius_m())),
      is_white_within_(IsWhite(outline_, white_m_)) {
  const Cells print = DrawPrint(pad, outline_);
  print_ = Smoothed(print, Sharpness(pad));
  blurred_ = Smoothed(print, kBlurred);
}

bool PadTemplateMatcher::IsAt(const models::ImageView& image, const PadPlane& plane,
                              std::span<const TemplateWarp> places) const {
  const auto within = Within(image, plane);
  return within && std::any_of(places.begin(), places.end(), [&](const TemplateWarp& place) {
           return Passes(At(within->disc, place), within->ring_contrast);
         });
}

std::optional<PadTemplateMatcher::Found> PadTemplateMatcher::Find(const models::ImageView& image,
                                                                  const PadPlane& plane) const {
  const auto within = Within(image, plane);
  if (!within) return std::nullopt;
  const auto& [disc, ring_contrast] = *within;
  constexpr double kNoiseShare = 0.15, kLeastZncc = 0.3;
  const Cells leveled = disc.ContrastNormalized(kNoiseShare * ring_contrast);
  const TemplateWarp turned = Turned(leveled, disc);
  if (Zncc(leveled, disc, turned, 1) < kLeastZncc) return std::nullopt;
  const Found found = Refined(leveled, disc, turned);
  constexpr double kLargestSize = 1.1;
  const double size = std::sqrt(found.place.scale.prod());
  if (size > kLargestSize || size < 1.0 / kLargestSize) return std::nullopt;
  if (!Passes(At(disc, found.place), ring_contrast)) return std::nullopt;
  return found;
}

std::optional<PadTemplateMatcher::WithinRing> PadTemplateMatcher::Within(const models::ImageView& image,
                                                                         const PadPlane& plane) const {
  constexpr double kFaintest = 5.0;
  const SeenRing ring = RingAt(image, plane);
  if (ring.contrast < kFaintest || ring.share < config_.least_ring) return std::nullopt;
  const auto disc = RectifiedDisc::Of(image, plane, reach_m_);
  if (!disc) return std::nullopt;
  return WithinRing{*disc, ring.contrast};
}

PadTemplateMatcher::Seen PadTemplateMatcher::At(const RectifiedDisc& disc, const TemplateWarp& place) const {
  const double margin_m = EdgeMargin(pad_, outline_, disc.cell_m());
  constexpr float kSurelyWhite = 0.1F, kSurelyBlack = 0.9F;
  Cells black(kCells, kCells), white(kCells, kCells), expected(kCells, kCells);
  Eigen::ArrayXXi parts = Eigen::ArrayXXi::Constant(kCells, kCells, -1);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const Vector2d p_W = place.OnTemplate(disc.PointOf(column, row));
      expected(row, column) = BlackAt(print_, p_W);
      const bool inside = disc.Holds(column, row);
      black(row, column) = inside && expected(row, column) > kSurelyBlack;
      white(row, column) = inside && expected(row, column) < kSurelyWhite;
      const bool is_sure = black(row, column) + white(row, column) > 0.0F;
      if (is_sure) parts(row, column) = PartAt(pad_, outline_, margin_m, p_W).value_or(-1);
    }
  }
  const Cells paper = RectifiedDisc::LocalMean(disc.gray(), white);
  const Cells ink = RectifiedDisc::LocalMean(disc.gray(), black);
  Seen seen;
  seen.contrast = ((paper - ink) * black).sum() / std::max(1.0F, black.sum());

  constexpr double kDark = 0.45, kFaintest = 0.1;  // Of the way from paper to ink; of the mean contrast.
  std::array<double, kParts> right{}, all{};
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int part = parts(row, column);
      if (part < 0) continue;
      const double contrast = std::max<double>(paper(row, column) - ink(row, column), kFaintest * seen.contrast);
      const bool is_dark = paper(row, column) - disc.gray()(row, column) > kDark * contrast;
      const auto i = static_cast<std::size_t>(part);
      all[i] += 1.0;
      right[i] += is_dark == (expected(row, column) > 0.5F);
    }
  }
  const auto share = [&](int part) {
    const auto i = static_cast<std::size_t>(part);
    return all[i] > 0.0 ? right[i] / all[i] : 1.0;  // What is narrower than a cell tells nothing.
  };
  seen.bar = share(kBar);
  seen.between_strokes = std::min(share(kFirstBetween), share(kFirstBetween + 1));
  seen.stroke = 1.0;
  for (int i = 0; i < 4; ++i) {
    seen.stroke = std::min(seen.stroke, share(kFirstStroke + i));
    seen.strokes += share(kFirstStroke + i) / 4.0;
  }
  seen.beside = share(kBeside);
  return seen;
}

bool PadTemplateMatcher::Passes(const Seen& seen, double ring_contrast) const {
  const bool is_rectangle = pad_.letter() == models::PadLetter::kRectangle;
  const double least_bar = is_rectangle ? config_.least_rectangle : config_.least_bar;
  return seen.contrast >= config_.least_contrast * ring_contrast &&
         seen.between_strokes >= config_.least_between_strokes && seen.bar >= least_bar &&
         seen.stroke >= config_.least_stroke && seen.strokes >= config_.least_strokes &&
         seen.beside >= config_.least_beside;
}

/// Correlation, -1 to 1, of every stride-th cell with the print.
double PadTemplateMatcher::Zncc(const Cells& leveled, const RectifiedDisc& disc, const TemplateWarp& place,
                                int stride) const {
  const Eigen::Matrix2d to_print =
      place.scale.cwiseInverse().asDiagonal() * Eigen::Rotation2Dd(-place.angle).toRotationMatrix();
  double count = 0.0, a = 0.0, aa = 0.0, b = 0.0, bb = 0.0, ab = 0.0;
  for (int row = 0; row < kCells; row += stride) {
    for (int column = 0; column < kCells; column += stride) {
      if (!disc.Holds(column, row)) continue;
      const Vector2d p = disc.PointOf(column, row);
      const double seen = leveled(row, column), print = BlackAt(blurred_, to_print * (p - place.offset_m));
      count += 1.0;
      a += seen;
      aa += seen * seen;
      b += print;
      bb += print * print;
      ab += seen * print;
    }
  }
  const double variances = (aa - a * a / count) * (bb - b * b / count);
  return variances > 0.0 ? (ab - a * b / count) / std::sqrt(variances) : -1.0;
}

TemplateWarp PadTemplateMatcher::Turned(const Cells& leveled, const RectifiedDisc& disc) const {
  constexpr int kAngles = 45, kCoarse = 2;
  const int half_turns = pad_.marks.empty() ? 1 : 2;  // After one the H looks the same, marks may not.
  Found best{{}, -2.0};
  for (int i = 0; i < half_turns * kAngles; ++i) {
    const TemplateWarp place{.angle = models::kPi * i / kAngles};
    const double zncc = Zncc(leveled, disc, place, kCoarse);
    if (zncc > best.zncc) best = {place, zncc};
  }
  return best.place;
}

/// The place of the greatest zncc near `start`, a coordinate after the other in ever smaller steps.
PadTemplateMatcher::Found PadTemplateMatcher::Refined(const Cells& leveled, const RectifiedDisc& disc,
                                                      const TemplateWarp& start) const {
  const double radius = pad_.inner_radius_m(), farthest = kFarthestOffset * radius;
  const auto moved = [&](TemplateWarp place, int coordinate, double step) {
    constexpr double kTurn = 0.05, kShift = 0.03, kStretch = 0.05;
    if (coordinate == 0) place.angle += kTurn * step;
    if (coordinate == 1) place.offset_m.x() += kShift * radius * step;
    if (coordinate == 2) place.offset_m.y() += kShift * radius * step;
    if (coordinate == 3) place.scale.x() += kStretch * step;
    if (coordinate == 4) place.scale.y() += kStretch * step;
    place.offset_m = place.offset_m.cwiseMax(-farthest).cwiseMin(farthest);
    place.scale = place.scale.cwiseMax(1.0 / kLargestScale).cwiseMin(kLargestScale);
    return place;
  };
  Found best{start, -1.0};
  for (const double step : {1.0, 0.5, 0.25, 0.125}) {
    const int stride = step >= 0.5 ? 2 : 1;
    best.zncc = Zncc(leveled, disc, best.place, stride);
    constexpr int kRounds = 3;
    constexpr double kLeastGain = 1e-3;
    for (int round = 0; round < kRounds; ++round) {
      const double before = best.zncc;
      for (int coordinate = 0; coordinate < 5; ++coordinate) {
        for (const double sign : {-1.0, 1.0}) {
          const TemplateWarp place = moved(best.place, coordinate, sign * step);
          const double zncc = Zncc(leveled, disc, place, stride);
          if (zncc > best.zncc) best = {place, zncc};
        }
      }
      if (best.zncc < before + kLeastGain) break;
    }
  }
  return best;
}

PadTemplateMatcher::SeenRing PadTemplateMatcher::RingAt(const models::ImageView& image, const PadPlane& plane) const {
  constexpr int kDirections = 60, kSteps = 5;
  constexpr double kCurl = 0.03;  // Of the radius.
  const double from_m = pad_.inner_radius_m() - kCurl * pad_.outer_radius_m;
  const double step_m = (pad_.ring_width_m + 2.0 * kCurl * pad_.outer_radius_m) / (kSteps + 1);
  // Where the sheet's white goes on outside, it is looked at too.
  constexpr double kLeastMargin = 0.06, kOutside = 0.1;
  const double margin_m = 0.5 * std::min(pad_.sheet_length_m, pad_.sheet_width_m) - pad_.outer_radius_m;
  const bool has_margin = margin_m > kLeastMargin * pad_.outer_radius_m;
  const double outside_m = pad_.outer_radius_m + std::min(0.5 * margin_m, kOutside * pad_.outer_radius_m);
  std::vector<float> contrasts, ratios;  // Of white to black, and over the white: the same in a shadow.
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * models::kPi * i / kDirections;
    const auto gray_at = [&](double radius_m) -> std::optional<float> {
      const auto pixel = plane.PixelAt(radius_m * Vector2d(std::cos(angle), std::sin(angle)));
      return pixel ? GrayAt(image, *pixel) : std::nullopt;
    };
    auto darkest = gray_at(from_m + step_m);
    for (int k = 2; k <= kSteps; ++k) darkest = std::min(darkest, gray_at(from_m + k * step_m));
    const auto within = gray_at(white_m_), outside = has_margin ? gray_at(outside_m) : within;
    if (!within || !darkest) return {};
    const float around = outside.value_or(*within);
    const float white = is_white_within_ ? std::min(*within, around) : has_margin ? around : std::max(*within, around);
    contrasts.push_back(white - *darkest);
    ratios.push_back((white - *darkest) / std::max(white, 1.0F));
  }
  const float usual_ratio = Quantile(ratios, 0.8);
  constexpr float kDark = 0.45F;
  const auto dark = std::count_if(ratios.begin(), ratios.end(), [&](float r) { return r > kDark * usual_ratio; });
  return {Quantile(contrasts, 0.5), static_cast<double>(dark) / kDirections};
}

float PadTemplateMatcher::BlackAt(const Cells& print, const Vector2d& p_W) const {
  const double texels_per_m = kTexels / (2.0 * pad_.inner_radius_m()), middle = 0.5 * kTexels;
  const auto texel = [&](double coordinate_m) {
    return std::clamp(static_cast<int>(middle + texels_per_m * coordinate_m), 0, kTexels - 1);
  };
  return print(texel(p_W.y()), texel(p_W.x()));
}

}  // namespace touchdown::estimator::pad
