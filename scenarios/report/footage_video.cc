#include "scenarios/report/footage_video.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "scenarios/report/annotated_frame.h"

namespace touchdown::report {
namespace {

const cv::Size kMostVideo(1280, 960);

FrameRate RateOf(double frames_per_s) {
  constexpr int kSeconds = 1000;
  return {.pictures = static_cast<int>(std::lround(frames_per_s * kSeconds)), .seconds = kSeconds};
}

}  // namespace

FootageVideo::FootageVideo(const std::filesystem::path& file, const datasets::FootageSetup& setup,
                           const datasets::FootageFacts& facts)
    : camera_(setup.camera),
      axis_length_m_(setup.pad.outer_radius_m),
      X_BC_(setup.mounting ? setup.mounting->X_BC : Eigen::Isometry3d::Identity()),
      time_(facts.time),
      size_(VideoSize({setup.camera.width_px, setup.camera.height_px}, kMostVideo)),
      writer_(file, size_, RateOf(facts.frames_per_s)) {}

void FootageVideo::Add(const datasets::FootageFrame& frame, const datasets::FootageEstimate& estimate) {
  const estimator::FrameResult& seen = estimate.seen;
  FrameAnnotation annotation;
  annotation.overlay = seen.overlay;
  annotation.pad_px = seen.pad_px;
  annotation.axis_length_m = axis_length_m_;
  if (seen.pose) annotation.X_WC = seen.pose->X_WB * X_BC_;
  cv::Mat3b picture;
  cv::resize(AnnotateFrame(frame.image.View(), camera_, annotation), picture, size_, 0.0, 0.0, cv::INTER_AREA);
  std::string caption = fmt::format("{}  {}", frame.source, estimator::ReasonOrStatus(seen.status, seen.reason));
  if (frame.mid_exposure) caption = fmt::format("{:.2f} s  {}", time_.ToSeconds(*frame.mid_exposure), caption);
  DrawCaption(picture.rowRange(0, CaptionHeight(size_)), caption, CaptionColor(seen.status));
  writer_.Write(picture);
}

}  // namespace touchdown::report
