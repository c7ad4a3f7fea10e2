#include "scenarios/report/footage_video.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "scenarios/report/annotated_frame.h"

namespace touchdown::report {
namespace {

const cv::Size kMaxVideoSize(1280, 960);

FrameRate RateOf(double frames_per_s) {
  constexpr int kSeconds = 1000;
  return {.frames = static_cast<int>(std::lround(frames_per_s * kSeconds)), .seconds = kSeconds};
}

}  // namespace

FootageVideo::FootageVideo(const std::filesystem::path& file, const datasets::FootageSetup& setup,
                           const datasets::FootageMetadata& metadata)
    : camera_(setup.camera),
      axis_length_m_(setup.pad.outer_radius_m),
      X_BC_(setup.mounting ? setup.mounting->X_BC : Eigen::Isometry3d::Identity()),
      time_(metadata.time),
      size_(VideoSize({setup.camera.width_px, setup.camera.height_px}, kMaxVideoSize)),
      writer_(file, size_, RateOf(metadata.frames_per_s)) {}

void FootageVideo::Add(const datasets::FootageFrame& frame, const datasets::FootageEstimate& estimate) {
  const estimator::FrameResult& result = estimate.result;
  FrameAnnotation annotation;
  annotation.overlay = result.overlay;
  annotation.pad_px = result.pad_px;
  annotation.axis_length_m = axis_length_m_;
  if (result.pose) annotation.X_WC = result.pose->X_WB * X_BC_;
  cv::Mat3b video_frame;
  cv::resize(AnnotateFrame(frame.image.View(), camera_, annotation), video_frame, size_, 0.0, 0.0, cv::INTER_AREA);
  std::string caption = fmt::format("{}  {}", frame.source, estimator::ReasonOrStatus(result.status, result.reason));
  if (frame.mid_exposure) caption = fmt::format("{:.2f} s  {}", time_.ToSeconds(*frame.mid_exposure), caption);
  DrawCaption(video_frame.rowRange(0, CaptionHeight(size_)), caption, CaptionColor(result.status));
  writer_.Write(video_frame);
}

}  // namespace touchdown::report
