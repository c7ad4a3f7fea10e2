#include "scenarios/experiments/yaw_study.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "estimator/pad/ellipse_fit.h"
#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "estimator/paper/letter_ellipse.h"
#include "estimator/paper/pad_contours.h"
#include "models/angles.h"
#include "models/camera_model.h"
#include "models/error.h"
#include "models/landing_pad.h"
#include "models/pad_outline.h"
#include "models/signals.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector2d;
using estimator::paper::Component;
using estimator::paper::ComponentSet;
using models::LandingPad;

constexpr double kPaper = 215.0, kInk = 25.0;

LandingPad PadWithRectangle() {
  LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  return pad;
}

/// Synthetic image of a pad from straight above, on an unbounded sheet of paper. Each pixel is the mean over its
/// square.
class FrontalView {
 public:
  FrontalView(const LandingPad& pad, double height_m, double yaw)
      : pad_(pad),
        outline_(pad),
        m_per_px_(height_m / models::CameraModel().fx_px),
        side_px_(static_cast<int>(std::ceil(2.0 * kMargin * pad.outer_radius_m / m_per_px_))),
        W_from_image_(Eigen::Rotation2Dd(yaw - models::kPi / 2.0)) {}

  /// Renders a square image centered at the pad.
  models::Image Render() const {
    const int corners = side_px_ + 1;
    cv::Mat1b black(corners, corners);
    for (int v = 0; v < corners; ++v) {
      for (int u = 0; u < corners; ++u) black(v, u) = IsBlack({u - 0.5, v - 0.5}) ? 1 : 0;
    }
    models::Image image(side_px_, side_px_);
    for (int v = 0; v < side_px_; ++v) {
      for (int u = 0; u < side_px_; ++u) {
        const int sum = black(v, u) + black(v, u + 1) + black(v + 1, u) + black(v + 1, u + 1);
        const double coverage = sum % 4 == 0 ? sum / 4.0 : CoverageOf(u, v);
        image.Row(v)[u] = static_cast<std::uint8_t>(std::lround(kPaper + coverage * (kInk - kPaper)));
      }
    }
    return image;
  }

  /// Whether the pixel is closer to the letter than to the ring.
  bool IsWithinRing(int u, int v) const {
    const double letter_reach_m = 0.5 * std::hypot(pad_.h_height_m, pad_.h_width_m);
    return PointAt(Vector2d(u, v)).norm() < 0.5 * (letter_reach_m + pad_.inner_radius_m());
  }

 private:
  static constexpr double kMargin = 1.2;  // Half the side of the image divided by the outer radius of the ring.

  /// Point of the pad plane at a pixel, in W. The image's up direction is W's X axis rotated counterclockwise by the
  /// yaw.
  Vector2d PointAt(const Vector2d& pixel) const {
    const Vector2d from_center = pixel - Vector2d::Constant(0.5 * (side_px_ - 1));
    return m_per_px_ * (W_from_image_ * Vector2d(from_center.x(), -from_center.y()));
  }

  /// Whether the pad is black at a pixel position.
  bool IsBlack(const Vector2d& pixel) const { return outline_.IsBlack(PointAt(pixel)); }

  /// Fraction of a pixel that is black, by sampling.
  double CoverageOf(int u, int v) const {
    constexpr int kSamples = 8;
    int hits = 0;
    for (int n = 0; n < kSamples * kSamples; ++n) {
      const int across = n % kSamples, down = n / kSamples;
      const Vector2d within((across + 0.5) / kSamples - 0.5, (down + 0.5) / kSamples - 0.5);
      hits += IsBlack(Vector2d(u, v) + within) ? 1 : 0;
    }
    return static_cast<double>(hits) / (kSamples * kSamples);
  }

  const LandingPad& pad_;
  models::PadOutline outline_;
  double m_per_px_;
  int side_px_;
  Eigen::Matrix2d W_from_image_;  // Maps (right, up) in the image to W.
};

/// The ring and the letter, which must be the only components.
estimator::paper::DetectedPad RingAndLetter(const ComponentSet& set) {
  std::vector<Component> components = set.components;
  if (components.size() != 2) throw std::logic_error("ring and letter are not the only components of a synthetic pad");
  if (components[0].width < components[1].width) std::swap(components[0], components[1]);
  return {components[0], components[1]};
}

/// Angle of the major axis of the ellipse that has the same central second moments as `darkness`; same convention as
/// estimator::pad::Ellipse::angle.
double MajorAxisAngle(const cv::Mat& darkness) {
  const cv::Moments m = cv::moments(darkness);
  return 0.5 * std::atan2(2.0 * m.mu11, m.mu20 - m.mu02);
}

/// Darkness of the pixels that the letter may cover; 0 for paper and for all other pixels.
cv::Mat1f Darkness(const FrontalView& view, const models::Image& image) {
  cv::Mat1f darkness = cv::Mat1f::zeros(image.height, image.width);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      if (view.IsWithinRing(u, v)) darkness(v, u) = static_cast<float>(kPaper - image.View().Row(v)[u]);
    }
  }
  return darkness;
}

/// Synthetic view of a pad, its two components, and the yaw errors of all methods on it.
class SyntheticPadView {
 public:
  SyntheticPadView(const LandingPad& pad, double height_m, double yaw)
      : pad_(pad),
        yaw_(yaw),
        letter_(pad),
        view_(pad, height_m, yaw),
        image_(view_.Render()),
        components_(estimator::paper::ExtractComponents(estimator::paper::Binarize(image_.View()).View())),
        detected_(RingAndLetter(components_)) {}

  double ErrorOfEllipse_deg(estimator::pad::ContourPoints points) const {
    const auto contours =
        estimator::paper::FindContours(image_.View(), components_, detected_, pad_, {.contour_points = points});
    const auto ellipse = estimator::pad::FitEllipse(contours.letter);
    if (!ellipse) throw std::logic_error("a synthetic letter has no ellipse");
    return Error_deg(*ellipse);
  }

  double ErrorOfBinaryMoments_deg() const {
    return Error_deg({.angle = MajorAxisAngle(Darkness(view_, image_) > 0.5 * (kPaper - kInk))});
  }

  double ErrorOfGrayMoments_deg() const { return Error_deg({.angle = MajorAxisAngle(Darkness(view_, image_))}); }

 private:
  double Error_deg(const estimator::pad::Ellipse& ellipse) const {
    // A left yaw of the camera rotates the strokes right in the image.
    const double true_angle = yaw_ - models::kPi / 2.0;
    return models::RadToDeg(models::WrapToHalfPi(letter_.StrokeAngle(ellipse) - true_angle));
  }

  const LandingPad& pad_;
  double yaw_;
  estimator::paper::LetterEllipse letter_;
  FrontalView view_;
  models::Image image_;
  ComponentSet components_;
  estimator::paper::DetectedPad detected_;
};

}  // namespace

std::vector<YawErrors> StudyYaw(double height_m) {
  constexpr double kLowest_m = 0.1, kHighest_m = 2.0;
  if (!(height_m >= kLowest_m && height_m <= kHighest_m)) {
    throw InputError("the height of the yaw study must be in [0.1, 2] m");
  }
  const LandingPad with_h, with_rectangle = PadWithRectangle();
  std::vector<YawErrors> rows;
  for (int yaw_deg = 0; yaw_deg < 360; ++yaw_deg) {
    const double yaw = models::DegToRad(yaw_deg);
    const SyntheticPadView h(with_h, height_m, yaw), rectangle(with_rectangle, height_m, yaw);
    rows.push_back({yaw_deg,
                    {h.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kInteger),
                     h.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kSubpixel), h.ErrorOfBinaryMoments_deg(),
                     h.ErrorOfGrayMoments_deg(), rectangle.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kInteger),
                     rectangle.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kSubpixel)}});
  }
  return rows;
}

ErrorSummary SummarizeErrors(std::span<const YawErrors> rows, YawMethod method) {
  ErrorSummary summary;
  for (const YawErrors& row : rows) {
    summary.largest_deg = std::max(summary.largest_deg, std::abs(row.Of(method)));
    summary.rms_deg += row.Of(method) * row.Of(method) / static_cast<double>(rows.size());
  }
  summary.rms_deg = std::sqrt(summary.rms_deg);
  return summary;
}

}  // namespace touchdown::experiments
