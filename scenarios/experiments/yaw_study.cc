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

/// The pad from straight above, on endless paper; each pixel the mean over its own square.
class FrontalView {
 public:
  FrontalView(const LandingPad& pad, double height_m, double yaw)
      : pad_(pad),
        outline_(pad),
        m_per_px_(height_m / models::CameraModel().fx_px),
        side_px_(static_cast<int>(std::ceil(2.0 * kMargin * pad.outer_radius_m / m_per_px_))),
        W_from_image_(Eigen::Rotation2Dd(yaw - models::kPi / 2.0)) {}

  /// A square picture about the pad's center.
  models::Image Picture() const {
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

  /// Whether the pixel lies nearer to the letter than to the ring.
  bool IsWithinRing(int u, int v) const {
    const double letter_reach_m = 0.5 * std::hypot(pad_.h_height_m, pad_.h_width_m);
    return PointAt(Vector2d(u, v)).norm() < 0.5 * (letter_reach_m + pad_.inner_radius_m());
  }

 private:
  static constexpr double kMargin = 1.2;  // Of the ring's radius.

  /// In W. The image's up is turned left by the yaw from W's X axis.
  Vector2d PointAt(const Vector2d& pixel) const {
    const Vector2d from_center = pixel - Vector2d::Constant(0.5 * (side_px_ - 1));
    return m_per_px_ * (W_from_image_ * Vector2d(from_center.x(), -from_center.y()));
  }

  bool IsBlack(const Vector2d& pixel) const { return outline_.IsBlack(PointAt(pixel)); }

  double CoverageOf(int u, int v) const {
    constexpr int kSamples = 8;
    int hits = 0;
    for (int n = 0; n < kSamples * kSamples; ++n) {
      const Vector2d within((n % kSamples + 0.5) / kSamples - 0.5, (n / kSamples + 0.5) / kSamples - 0.5);
      hits += IsBlack(Vector2d(u, v) + within) ? 1 : 0;
    }
    return static_cast<double>(hits) / (kSamples * kSamples);
  }

  const LandingPad& pad_;
  models::PadOutline outline_;
  double m_per_px_;
  int side_px_;
  Eigen::Matrix2d W_from_image_;  // From axes to the image's right and up.
};

/// Ring and letter: there is nothing else in the picture.
estimator::paper::DetectedPad PadAmong(const ComponentSet& set) {
  std::vector<Component> components = set.components;
  if (components.size() != 2) throw std::logic_error("ring and letter are not the only components of a synthetic pad");
  if (components[0].width < components[1].width) std::swap(components[0], components[1]);
  return {components[0], components[1]};
}

/// Of the major axis of the ellipse with the picture's central second moments, as estimator::Ellipse::angle.
double MajorAxis(const cv::Mat& darkness) {
  const cv::Moments m = cv::moments(darkness);
  return 0.5 * std::atan2(2.0 * m.mu11, m.mu20 - m.mu02);
}

/// Of each pixel that the letter may cover, 0 on paper.
cv::Mat1f Darkness(const FrontalView& view, const models::Image& image) {
  cv::Mat1f darkness = cv::Mat1f::zeros(image.height, image.width);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      if (view.IsWithinRing(u, v)) darkness(v, u) = static_cast<float>(kPaper - image.View().Row(v)[u]);
    }
  }
  return darkness;
}

/// A pad seen from above, cut into its two components.
class SeenPad {
 public:
  SeenPad(const LandingPad& pad, double height_m, double yaw)
      : pad_(pad),
        yaw_(yaw),
        letter_(pad),
        view_(pad, height_m, yaw),
        image_(view_.Picture()),
        components_(estimator::paper::ExtractComponents(estimator::paper::Binarize(image_.View()).View())),
        detected_(PadAmong(components_)) {}

  double ErrorOfEllipse_deg(estimator::pad::ContourPoints points) const {
    const auto contours =
        estimator::paper::FindContours(image_.View(), components_, detected_, pad_, {.contour_points = points});
    const auto ellipse = estimator::pad::FitEllipse(contours.letter);
    if (!ellipse) throw std::logic_error("a synthetic letter has no ellipse");
    return Error_deg(*ellipse);
  }

  double ErrorOfBinaryMoments_deg() const {
    return Error_deg({.angle = MajorAxis(Darkness(view_, image_) > 0.5 * (kPaper - kInk))});
  }

  double ErrorOfGrayMoments_deg() const { return Error_deg({.angle = MajorAxis(Darkness(view_, image_))}); }

 private:
  double Error_deg(const estimator::pad::Ellipse& seen) const {
    const double true_angle = yaw_ - models::kPi / 2.0;  // Turned left, the camera sees the strokes turned right.
    return models::RadToDeg(models::WrapToHalfPi(letter_.StrokeAngle(seen) - true_angle));
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
    throw InputError("the yaw study's height must be within [0.1, 2] m");
  }
  const LandingPad with_h, with_rectangle = PadWithRectangle();
  std::vector<YawErrors> rows;
  for (int yaw_deg = 0; yaw_deg < 360; ++yaw_deg) {
    const double yaw = models::DegToRad(yaw_deg);
    const SeenPad h(with_h, height_m, yaw), rectangle(with_rectangle, height_m, yaw);
    rows.push_back({yaw_deg,
                    {h.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kInteger),
                     h.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kSubpixel), h.ErrorOfBinaryMoments_deg(),
                     h.ErrorOfGrayMoments_deg(), rectangle.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kInteger),
                     rectangle.ErrorOfEllipse_deg(estimator::pad::ContourPoints::kSubpixel)}});
  }
  return rows;
}

ErrorSize SizeOfErrors(std::span<const YawErrors> rows, YawMethod method) {
  ErrorSize size;
  for (const YawErrors& row : rows) {
    size.largest_deg = std::max(size.largest_deg, std::abs(row.Of(method)));
    size.rms_deg += row.Of(method) * row.Of(method) / static_cast<double>(rows.size());
  }
  size.rms_deg = std::sqrt(size.rms_deg);
  return size;
}

}  // namespace touchdown::experiments
