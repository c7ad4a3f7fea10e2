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
constexpr double kBlurSigma = 0.03;  // In inner radii.
constexpr double kMaxOffset = 0.1;   // In inner radii.
constexpr double kMaxScale = 1.12;

float Quantile(const std::vector<float>& values, double fraction) {
  return models::OrderStatistic(values, static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1)));
}

/// Gray value at a pixel, interpolated bilinearly; nullopt outside the image.
std::optional<float> GrayAt(const models::ImageView& image, const Vector2d& pixel) {
  if (!models::IsBetweenPixels(image, pixel)) return std::nullopt;
  return models::BilinearGray<float>(image, pixel);
}

/// Artwork within the ring: black, 0 to 1.
Cells RenderTemplate(const models::LandingPad& pad, const models::PadOutline& outline) {
  constexpr int kSamples = 3;
  Cells texture(kTexels, kTexels);
  const double step = 2.0 * pad.inner_radius_m() / (kTexels * kSamples);
  for (int row = 0; row < kTexels; ++row) {
    for (int column = 0; column < kTexels; ++column) {
      int black = 0;
      for (int sample = 0; sample < kSamples * kSamples; ++sample) {
        const int across = sample % kSamples, down = sample / kSamples;
        const Vector2d p_W(step * (kSamples * column + across + 0.5) - pad.inner_radius_m(),
                           step * (kSamples * row + down + 0.5) - pad.inner_radius_m());
        black += p_W.norm() < pad.inner_radius_m() && outline.IsBlack(p_W);
      }
      texture(row, column) = static_cast<float>(black) / (kSamples * kSamples);
    }
  }
  return texture;
}

/// The texture blurred with a standard deviation of `sigma`, in inner radii.
Cells Smoothed(const Cells& texture, double sigma) {
  Cells smoothed(kTexels, kTexels);
  const cv::Mat1f source(kTexels, kTexels, const_cast<float*>(texture.data()));
  cv::Mat1f target(kTexels, kTexels, smoothed.data());
  cv::GaussianBlur(source, target, {}, sigma * kTexels / 2.0, 0.0, cv::BORDER_CONSTANT);
  return smoothed;
}

/// Distance of the letter's corners from its center, m.
double LetterRadius(const models::LandingPad& pad) { return 0.5 * std::hypot(pad.h_height_m, pad.h_width_m); }

/// Whether a circle around W's origin has no black.
bool IsWhite(const models::PadOutline& outline, double radius_m) {
  constexpr int kDirections = 360;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * models::kPi * i / kDirections;
    if (outline.IsBlack(radius_m * Vector2d(std::cos(angle), std::sin(angle)))) return false;
  }
  return true;
}

/// Standard deviation, in inner radii, of a blur after which the middle of a stroke is still black.
double SharpSigma(const models::LandingPad& pad) {
  constexpr double kMaxSigma = 0.012, kPerStroke = 0.15;
  return std::min(kMaxSigma, kPerStroke * pad.h_stroke_m / pad.inner_radius_m());
}

/// Distance from the letter's edges, m, within which cells are ignored.
double EdgeMargin(const models::LandingPad& pad, const models::PadOutline& outline, double cell_m) {
  const double narrowest_m = std::min(pad.h_stroke_m, models::NarrowestPart(outline.letter()));
  return std::min(0.25 * narrowest_m, 0.1 * pad.h_stroke_m + 0.5 * cell_m);
}

/// Parts of an H, each of which another letter may lack. For a rectangle the four corners take the role of the stroke
/// ends, and the rest that of the bar.
enum Part { kBar, kFirstStroke, kFirstBetween = kFirstStroke + 4, kBeside = kFirstBetween + 2, kParts };

/// The part to which a point belongs; nullopt within `margin_m` of the letter's edges and where bar and strokes meet.
std::optional<int> PartAt(const models::LandingPad& pad, const models::PadOutline& outline, double margin_m,
                          const Vector2d& p_W) {
  const Vector2d p = p_W.cwiseAbs(), half_size = 0.5 * Vector2d(pad.h_height_m, pad.h_width_m);
  const auto is_in_box = [&](double grown_by_m) { return (p.array() < half_size.array() + grown_by_m).all(); };
  if (!is_in_box(margin_m)) return is_in_box(pad.h_stroke_m) ? std::optional<int>(kBeside) : std::nullopt;
  if (!is_in_box(0.0) || outline.DistanceFromLetter(p_W) <= margin_m) return std::nullopt;
  if (!outline.IsLetter(p_W)) return kFirstBetween + (p_W.x() > 0.0 ? 1 : 0);
  const int stroke_end = kFirstStroke + (p_W.x() > 0.0 ? 1 : 0) + (p_W.y() > 0.0 ? 2 : 0);
  if (pad.letter() == models::PadLetter::kRectangle) {
    constexpr double kCorner = 0.7;  // In half sizes from the center. An ellipse of equal area covers half of a corner.
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
  for (const double fraction :
       {min_ring, min_between_strokes, min_bar, min_rectangle, min_stroke, min_strokes, min_beside, min_contrast}) {
    if (!(fraction > 0.0 && fraction <= 1.0)) {
      throw InputError("the minimum fractions of the template matcher must be above 0 and at most 1");
    }
  }
}

PadTemplateMatcher::PadTemplateMatcher(const models::LandingPad& pad, const TemplateMatcherConfig& config)
    : pad_(pad),
      outline_(pad),
      config_(config),
      disc_radius_m_(
          std::min(0.98 * pad.inner_radius_m(), 1.15 * LetterRadius(pad) + kMaxOffset * pad.inner_radius_m())),
      white_radius_m_(std::max(0.5 * (LetterRadius(pad) + pad.inner_radius_m()), 0.85 * pad.inner_radius_m())),
      is_white_circle_(IsWhite(outline_, white_radius_m_)) {
  const Cells artwork = RenderTemplate(pad, outline_);
  template_ = Smoothed(artwork, SharpSigma(pad));
  blurred_template_ = Smoothed(artwork, kBlurSigma);
}

bool PadTemplateMatcher::MatchesAt(const models::ImageView& image, const PadPlane& plane,
                                   std::span<const TemplateWarp> warps) const {
  const auto interior = RectifyInterior(image, plane);
  return interior && std::any_of(warps.begin(), warps.end(), [&](const TemplateWarp& warp) {
           return Passes(ScoreParts(interior->disc, warp), interior->ring_contrast);
         });
}

std::optional<PadTemplateMatcher::Match> PadTemplateMatcher::Find(const models::ImageView& image,
                                                                  const PadPlane& plane) const {
  const auto interior = RectifyInterior(image, plane);
  if (!interior) return std::nullopt;
  const auto& [disc, ring_contrast] = *interior;
  constexpr double kMinRelativeStddev = 0.15, kMinZncc = 0.3;
  const Cells normalized = disc.ContrastNormalized(kMinRelativeStddev * ring_contrast);
  const TemplateWarp coarse = CoarseOrientation(normalized, disc);
  if (Zncc(normalized, disc, coarse, 1) < kMinZncc) return std::nullopt;
  const Match match = RefineWarp(normalized, disc, coarse);
  constexpr double kMaxSize = 1.1;
  const double size = std::sqrt(match.warp.scale.prod());
  if (size > kMaxSize || size < 1.0 / kMaxSize) return std::nullopt;
  if (!Passes(ScoreParts(disc, match.warp), ring_contrast)) return std::nullopt;
  return match;
}

std::optional<PadTemplateMatcher::RingInterior> PadTemplateMatcher::RectifyInterior(const models::ImageView& image,
                                                                                    const PadPlane& plane) const {
  constexpr double kMinRingContrast = 5.0;
  const RingScore ring = ScoreRing(image, plane);
  if (ring.contrast < kMinRingContrast || ring.fraction < config_.min_ring) return std::nullopt;
  const auto disc = RectifiedDisc::Of(image, plane, disc_radius_m_);
  if (!disc) return std::nullopt;
  return RingInterior{*disc, ring.contrast};
}

PadTemplateMatcher::PartScores PadTemplateMatcher::ScoreParts(const RectifiedDisc& disc,
                                                              const TemplateWarp& warp) const {
  const double margin_m = EdgeMargin(pad_, outline_, disc.cell_m());
  constexpr float kSurelyWhite = 0.1F, kSurelyBlack = 0.9F;
  Cells black(kCells, kCells), white(kCells, kCells), expected(kCells, kCells);
  Eigen::ArrayXXi parts = Eigen::ArrayXXi::Constant(kCells, kCells, -1);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const Vector2d p_W = warp.OnTemplate(disc.CellCenter(column, row));
      expected(row, column) = BlackAt(template_, p_W);
      const bool inside = disc.Contains(column, row);
      black(row, column) = inside && expected(row, column) > kSurelyBlack;
      white(row, column) = inside && expected(row, column) < kSurelyWhite;
      const bool is_sure = black(row, column) + white(row, column) > 0.0F;
      if (is_sure) parts(row, column) = PartAt(pad_, outline_, margin_m, p_W).value_or(-1);
    }
  }
  const Cells paper = RectifiedDisc::LocalMean(disc.gray(), white);
  const Cells ink = RectifiedDisc::LocalMean(disc.gray(), black);
  PartScores scores;
  scores.contrast = ((paper - ink) * black).sum() / std::max(1.0F, black.sum());

  constexpr double kDark = 0.45;                // Fraction of the way from paper to ink.
  constexpr double kMinRelativeContrast = 0.1;  // Fraction of the mean contrast.
  std::array<double, kParts> correct{}, total{};
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int part = parts(row, column);
      if (part < 0) continue;
      const double contrast =
          std::max<double>(paper(row, column) - ink(row, column), kMinRelativeContrast * scores.contrast);
      const bool is_dark = paper(row, column) - disc.gray()(row, column) > kDark * contrast;
      const auto i = static_cast<std::size_t>(part);
      total[i] += 1.0;
      correct[i] += is_dark == (expected(row, column) > 0.5F);
    }
  }
  const auto fraction = [&](int part) {
    const auto i = static_cast<std::size_t>(part);
    return total[i] > 0.0 ? correct[i] / total[i] : 1.0;  // A part narrower than a cell has no information.
  };
  scores.bar = fraction(kBar);
  scores.between_strokes = std::min(fraction(kFirstBetween), fraction(kFirstBetween + 1));
  scores.stroke = 1.0;
  for (int i = 0; i < 4; ++i) {
    scores.stroke = std::min(scores.stroke, fraction(kFirstStroke + i));
    scores.strokes += fraction(kFirstStroke + i) / 4.0;
  }
  scores.beside = fraction(kBeside);
  return scores;
}

bool PadTemplateMatcher::Passes(const PartScores& scores, double ring_contrast) const {
  const bool is_rectangle = pad_.letter() == models::PadLetter::kRectangle;
  const double min_bar = is_rectangle ? config_.min_rectangle : config_.min_bar;
  return scores.contrast >= config_.min_contrast * ring_contrast &&
         scores.between_strokes >= config_.min_between_strokes && scores.bar >= min_bar &&
         scores.stroke >= config_.min_stroke && scores.strokes >= config_.min_strokes &&
         scores.beside >= config_.min_beside;
}

/// Zero-mean normalized cross-correlation, -1 to 1, of every `stride`-th cell with the blurred template.
double PadTemplateMatcher::Zncc(const Cells& normalized, const RectifiedDisc& disc, const TemplateWarp& warp,
                                int stride) const {
  const Eigen::Matrix2d to_template =
      warp.scale.cwiseInverse().asDiagonal() * Eigen::Rotation2Dd(-warp.angle).toRotationMatrix();
  double count = 0.0, a = 0.0, aa = 0.0, b = 0.0, bb = 0.0, ab = 0.0;
  for (int row = 0; row < kCells; row += stride) {
    for (int column = 0; column < kCells; column += stride) {
      if (!disc.Contains(column, row)) continue;
      const Vector2d p = disc.CellCenter(column, row);
      const double measured = normalized(row, column);
      const double expected = BlackAt(blurred_template_, to_template * (p - warp.offset_m));
      count += 1.0;
      a += measured;
      aa += measured * measured;
      b += expected;
      bb += expected * expected;
      ab += measured * expected;
    }
  }
  const double variances = (aa - a * a / count) * (bb - b * b / count);
  return variances > 0.0 ? (ab - a * b / count) / std::sqrt(variances) : -1.0;
}

/// The warp with the greatest ZNCC among rotations without offset.
TemplateWarp PadTemplateMatcher::CoarseOrientation(const Cells& normalized, const RectifiedDisc& disc) const {
  constexpr int kAngles = 45, kCoarse = 2;
  const int half_turns = pad_.marks.empty() ? 1 : 2;  // An H is symmetric under a half turn; markings may not be.
  Match best{{}, -2.0};
  for (int i = 0; i < half_turns * kAngles; ++i) {
    const TemplateWarp warp{.angle = models::kPi * i / kAngles};
    const double zncc = Zncc(normalized, disc, warp, kCoarse);
    if (zncc > best.zncc) best = {warp, zncc};
  }
  return best.warp;
}

/// The warp with the greatest ZNCC near `start`, found by coordinate descent with decreasing steps.
PadTemplateMatcher::Match PadTemplateMatcher::RefineWarp(const Cells& normalized, const RectifiedDisc& disc,
                                                         const TemplateWarp& start) const {
  const double radius = pad_.inner_radius_m(), max_offset_m = kMaxOffset * radius;
  const auto moved = [&](TemplateWarp warp, int coordinate, double step) {
    constexpr double kRotation = 0.05, kShift = 0.03, kStretch = 0.05;
    if (coordinate == 0) warp.angle += kRotation * step;
    if (coordinate == 1) warp.offset_m.x() += kShift * radius * step;
    if (coordinate == 2) warp.offset_m.y() += kShift * radius * step;
    if (coordinate == 3) warp.scale.x() += kStretch * step;
    if (coordinate == 4) warp.scale.y() += kStretch * step;
    warp.offset_m = warp.offset_m.cwiseMax(-max_offset_m).cwiseMin(max_offset_m);
    warp.scale = warp.scale.cwiseMax(1.0 / kMaxScale).cwiseMin(kMaxScale);
    return warp;
  };
  Match best{start, -1.0};
  for (const double step : {1.0, 0.5, 0.25, 0.125}) {
    const int stride = step >= 0.5 ? 2 : 1;
    best.zncc = Zncc(normalized, disc, best.warp, stride);
    constexpr int kRounds = 3;
    constexpr double kMinGain = 1e-3;
    for (int round = 0; round < kRounds; ++round) {
      const double before = best.zncc;
      for (int coordinate = 0; coordinate < 5; ++coordinate) {
        for (const double sign : {-1.0, 1.0}) {
          const TemplateWarp warp = moved(best.warp, coordinate, sign * step);
          const double zncc = Zncc(normalized, disc, warp, stride);
          if (zncc > best.zncc) best = {warp, zncc};
        }
      }
      if (best.zncc < before + kMinGain) break;
    }
  }
  return best;
}

PadTemplateMatcher::RingScore PadTemplateMatcher::ScoreRing(const models::ImageView& image,
                                                            const PadPlane& plane) const {
  constexpr int kDirections = 60, kSteps = 5;
  constexpr double kCurl = 0.03;  // Fraction of the outer radius, for paper that is not flat.
  const double from_m = pad_.inner_radius_m() - kCurl * pad_.outer_radius_m;
  const double step_m = (pad_.ring_width_m + 2.0 * kCurl * pad_.outer_radius_m) / (kSteps + 1);
  // Where the sheet has white outside the ring, that white is measured too.
  constexpr double kMinMargin = 0.06, kOutside = 0.1;
  const double margin_m = 0.5 * std::min(pad_.sheet_length_m, pad_.sheet_width_m) - pad_.outer_radius_m;
  const bool has_margin = margin_m > kMinMargin * pad_.outer_radius_m;
  const double outside_m = pad_.outer_radius_m + std::min(0.5 * margin_m, kOutside * pad_.outer_radius_m);
  std::vector<float> contrasts;  // White minus black.
  std::vector<float> ratios;     // Contrast divided by white, which does not change in a shadow.
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * models::kPi * i / kDirections;
    const auto gray_at = [&](double radius_m) -> std::optional<float> {
      const auto pixel = plane.PixelAt(radius_m * Vector2d(std::cos(angle), std::sin(angle)));
      return pixel ? GrayAt(image, *pixel) : std::nullopt;
    };
    auto darkest = gray_at(from_m + step_m);
    for (int k = 2; k <= kSteps; ++k) darkest = std::min(darkest, gray_at(from_m + k * step_m));
    const auto within = gray_at(white_radius_m_), outside = has_margin ? gray_at(outside_m) : within;
    if (!within || !darkest) return {};
    const float around = outside.value_or(*within);
    const float white = is_white_circle_ ? std::min(*within, around) : has_margin ? around : std::max(*within, around);
    contrasts.push_back(white - *darkest);
    ratios.push_back((white - *darkest) / std::max(white, 1.0F));
  }
  const float typical_ratio = Quantile(ratios, 0.8);
  constexpr float kDark = 0.45F;
  const auto dark = std::count_if(ratios.begin(), ratios.end(), [&](float r) { return r > kDark * typical_ratio; });
  return {Quantile(contrasts, 0.5), static_cast<double>(dark) / kDirections};
}

float PadTemplateMatcher::BlackAt(const Cells& texture, const Vector2d& p_W) const {
  const double texels_per_m = kTexels / (2.0 * pad_.inner_radius_m()), middle = 0.5 * kTexels;
  const auto texel = [&](double coordinate_m) {
    return std::clamp(static_cast<int>(middle + texels_per_m * coordinate_m), 0, kTexels - 1);
  };
  return texture(texel(p_W.y()), texel(p_W.x()));
}

}  // namespace touchdown::estimator::pad
