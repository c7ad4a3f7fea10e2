#include "scenarios/report/annotated_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "models/angles.h"

namespace touchdown::report {
namespace {

using estimator::Overlay;
using Role = Overlay::Role;
using Eigen::Vector2d;

// Blue, green, red.
const cv::Scalar kGreen(60, 190, 60), kBlue(230, 110, 30), kRed(60, 60, 220), kOrange(0, 140, 255),
    kYellow(0, 230, 255), kWhite(255, 255, 255);
const std::array<cv::Scalar, 3> kAxisColors = {cv::Scalar(0, 0, 255), cv::Scalar(0, 220, 0), cv::Scalar(255, 60, 0)};

constexpr double kCaptionHeight_px = 27.0;

/// Fractional bits of the sub-pixel coordinates that OpenCV draws.
constexpr int kShift = 4;
cv::Point FixedPoint(const Vector2d& pixel) {
  return {static_cast<int>(std::lround(pixel.x() * (1 << kShift))),
          static_cast<int>(std::lround(pixel.y() * (1 << kShift)))};
}

/// Drawing order of the roles, bottom layer first.
constexpr std::array kDrawingOrder = {Role::kOther, Role::kOutline, Role::kMarking, Role::kFit};

cv::Scalar ColorOf(Role role) {
  switch (role) {
    case Role::kOther:
      return kRed;
    case Role::kOutline:
      return kGreen;
    case Role::kMarking:
      return kBlue;
    case Role::kFit:
      return kYellow;
  }
  throw std::logic_error("overlay role without a color");
}

/// Factor of line widths and text sizes, relative to a frame of 640x480 px.
double ScaleOf(const cv::Size& size) { return std::sqrt(static_cast<double>(size.area()) / (640.0 * 480.0)); }

/// Draws annotations into one frame.
class Pen {
 public:
  Pen(cv::Mat3b& image, const models::CameraModel& camera)
      : image_(image), camera_(camera), scale_(ScaleOf(image.size())) {}

  void Box(const Overlay::Box& box) {
    cv::rectangle(image_, cv::Rect(box.box.u, box.box.v, box.box.width, box.box.height), ColorOf(box.role),
                  Width(box.role == Role::kOther ? 1.0 : 2.0));
  }

  void Polyline(const Overlay::Polyline& polyline) {
    std::vector<cv::Point> points;
    for (const Vector2d& point : polyline.points) {
      if (!IsNear(point)) return;
      points.push_back(FixedPoint(point));
    }
    cv::polylines(image_, points, polyline.closed, ColorOf(polyline.role), Width(1.0), cv::LINE_AA, kShift);
  }

  void Text(const Overlay::Label& label) {
    constexpr double kFontScale = 0.5;
    if (!IsNear(label.position)) return;
    cv::putText(image_, label.text,
                {static_cast<int>(std::lround(label.position.x())), static_cast<int>(std::lround(label.position.y()))},
                cv::FONT_HERSHEY_SIMPLEX, kFontScale * scale_, ColorOf(label.role), Width(1.0), cv::LINE_AA);
  }

  void EllipseWithAxes(const Overlay::Ellipse& ellipse) {
    constexpr int kPoints = 90;
    const Vector2d along(std::cos(ellipse.angle), std::sin(ellipse.angle)), across(-along.y(), along.x());
    const Vector2d major = ellipse.semi_axes.x() * along, minor = ellipse.semi_axes.y() * across;
    std::vector<cv::Point> points;
    for (int i = 0; i < kPoints; ++i) {
      const double t = 2.0 * models::kPi * i / kPoints;
      points.push_back(FixedPoint(RawPixel(ellipse.center + std::cos(t) * major + std::sin(t) * minor)));
    }
    const cv::Scalar color = ColorOf(ellipse.role);
    cv::polylines(image_, points, true, color, Width(1.0), cv::LINE_AA, kShift);
    for (const Vector2d& axis : {major, minor}) {
      Line(RawPixel(ellipse.center - axis), RawPixel(ellipse.center + axis), color, 1.0);
    }
  }

  void Cross(const Vector2d& pixel) {
    cv::drawMarker(image_, {static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))},
                   kOrange, cv::MARKER_CROSS, Width(40.0), Width(3.0), cv::LINE_AA);
  }

  /// Draws the axes of W. Omits an axis when the camera cannot project its ends near the image.
  void AxesOfW(const Eigen::Isometry3d& X_WC, double length_m) {
    const Eigen::Isometry3d X_CW = X_WC.inverse();
    const auto origin = camera_.Project(X_CW.translation());
    for (int axis = 0; axis < 3; ++axis) {
      const auto tip = camera_.Project(X_CW * (length_m * Eigen::Vector3d::Unit(axis)));
      if (!origin || !tip || !IsNear(*origin) || !IsNear(*tip)) continue;
      Line(*origin, *tip, kAxisColors[static_cast<std::size_t>(axis)], 3.0);
    }
  }

 private:
  int Width(double width_px) const { return std::max(1, static_cast<int>(std::lround(width_px * scale_))); }

  /// Whether a pixel is in the image or at most one image size outside it. OpenCV cannot draw shapes far outside.
  bool IsNear(const Vector2d& pixel) const {
    const Vector2d size(image_.cols, image_.rows);
    return ((pixel - 0.5 * size).cwiseAbs() - 1.5 * size).maxCoeff() < 0.0;
  }

  /// Raw pixel of an undistorted pixel. Ellipses are fitted to undistorted points.
  Vector2d RawPixel(const Vector2d& undistorted) const {
    return camera_.PixelFromNormalized(camera_.Distort(camera_.NormalizedFromPixel(undistorted)));
  }

  void Line(const Vector2d& from, const Vector2d& to, const cv::Scalar& color, double width_px) {
    cv::line(image_, FixedPoint(from), FixedPoint(to), color, Width(width_px), cv::LINE_AA, kShift);
  }

  cv::Mat3b& image_;
  const models::CameraModel& camera_;
  double scale_;
};

}  // namespace

cv::Mat3b AnnotateFrame(const models::ImageView& image, const models::CameraModel& camera,
                        const FrameAnnotation& annotation) {
  // cv::Mat has no read-only view. The data are only read; the result is a copy.
  const cv::Mat gray(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                     static_cast<std::size_t>(image.stride));
  cv::Mat3b result;
  cv::cvtColor(gray, result, cv::COLOR_GRAY2BGR);
  Pen pen(result, camera);
  const Overlay& overlay = annotation.overlay;
  const auto draw = [](const auto& shapes, Role role, const auto& draw_one) {
    for (const auto& shape : shapes) {
      if (shape.role == role) draw_one(shape);
    }
  };
  for (const Role role : kDrawingOrder) {
    draw(overlay.boxes, role, [&](const Overlay::Box& box) { pen.Box(box); });
    draw(overlay.ellipses, role, [&](const Overlay::Ellipse& ellipse) { pen.EllipseWithAxes(ellipse); });
    draw(overlay.polylines, role, [&](const Overlay::Polyline& polyline) { pen.Polyline(polyline); });
    draw(overlay.labels, role, [&](const Overlay::Label& label) { pen.Text(label); });
  }
  if (annotation.pad_px) pen.Cross(*annotation.pad_px);
  if (annotation.X_WC) pen.AxesOfW(*annotation.X_WC, annotation.axis_length_m);
  return result;
}

cv::Scalar CaptionColor(estimator::FrameStatus status) {
  return status == estimator::FrameStatus::kOk ? kWhite : kYellow;
}

int CaptionHeight(const cv::Size& image) {
  return std::clamp(static_cast<int>(std::lround(kCaptionHeight_px * ScaleOf(image))), 1, image.height);
}

void DrawCaption(cv::Mat3b strip, const std::string& text, const cv::Scalar& color) {
  constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  constexpr double kFontScale = 0.58, kLeft_px = 8.0, kBaseline_px = 19.0;
  const double text_width_px = 2.0 * kLeft_px + cv::getTextSize(text, kFont, kFontScale, 1, nullptr).width;
  const double scale = std::min(strip.rows / kCaptionHeight_px, strip.cols / text_width_px);
  const auto px = [scale](double nominal_px) { return static_cast<int>(std::lround(scale * nominal_px)); };
  strip = cv::Vec3b(0, 0, 0);
  cv::putText(strip, text, {px(kLeft_px), px(kBaseline_px)}, kFont, kFontScale * scale, color, std::max(1, px(1.0)),
              cv::LINE_AA);
}

}  // namespace touchdown::report
