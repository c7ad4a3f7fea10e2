#include "scenarios/report/flight_video.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "scenarios/report/annotated_frame.h"
#include "sim/dynamics/world.h"

namespace touchdown::report {
namespace {

constexpr int kMaxFramesPerSecond = 30;
constexpr int kHeight_px = 480;
constexpr int kMaxOnboardWidth_px = 854;
constexpr int kCaption_px = 32;
const cv::Vec3b kBackground(40, 40, 40);

/// Number of camera frames per video frame.
int FrameStride(int camera_hz) { return (camera_hz + kMaxFramesPerSecond - 1) / kMaxFramesPerSecond; }

/// Size of the camera frame in the video.
cv::Size OnboardSize(const models::CameraModel& camera) {
  const double scale = std::min(static_cast<double>(kHeight_px) / camera.height_px,
                                static_cast<double>(kMaxOnboardWidth_px) / camera.width_px);
  const auto scaled = [scale](int px) { return std::max(1, static_cast<int>(std::lround(scale * px))); };
  return {scaled(camera.width_px), scaled(camera.height_px)};
}

int Even(int px) { return px + px % 2; }

std::string VideoCaption(const runner::FrameRecord& record, double time_s) {
  return fmt::format("{:6.2f} s   {}   {}   height {:.2f} m", time_s, Name(record.phase),
                     estimator::ReasonOrStatus(record.status, record.reason), record.X_WB.translation().z());
}

}  // namespace

FlightVideo::FlightVideo(const runner::Scenario& scenario, const std::filesystem::path& file)
    : file_(file),
      camera_(scenario.assumed_camera()),
      pad_(scenario.pad),
      vehicle_(scenario.vehicle),
      X_BC_(scenario.assumed_vehicle().X_BC()),
      time_(scenario.time),
      period_(scenario.time.PeriodOf(scenario.camera.rate_hz) * FrameStride(scenario.camera.rate_hz)),
      rate_{.frames = scenario.camera.rate_hz, .seconds = FrameStride(scenario.camera.rate_hz)} {}

void FlightVideo::OnStart(const sim::World& world) {
  chase_ = std::make_unique<sim::ChaseView>(world.model(), vehicle_);
  const int width_px = Even(OnboardSize(camera_).width) + chase_->view().width_px;
  video_frame_ = cv::Mat3b(kHeight_px + kCaption_px, width_px);
  video_frame_ = kBackground;
}

void FlightVideo::OnImu(const models::ImuSample& sample, bool /*at_rest*/) {
  last_tick_ = std::max(last_tick_, sample.tick);
}

void FlightVideo::RepeatFrameUntil(models::Tick tick) {
  while (writer_->count() * period_ < tick) writer_->Write(video_frame_);
}

void FlightVideo::DrawOnboard(const models::ImageView& image, const estimator::Overlay& overlay,
                              const runner::FrameRecord& record) {
  FrameAnnotation annotation{
      .overlay = overlay, .pad_px = record.pad_px, .X_WC = {}, .axis_length_m = pad_.outer_radius_m};
  if (record.status == estimator::FrameStatus::kOk) annotation.X_WC = record.pose->X_WB * X_BC_;
  const cv::Size size = OnboardSize(camera_);
  const cv::Rect region({0, (kHeight_px - size.height) / 2}, size);
  cv::resize(AnnotateFrame(image, camera_, annotation), video_frame_(region), size, 0.0, 0.0,
             size.width < camera_.width_px ? cv::INTER_AREA : cv::INTER_LINEAR);
}

void FlightVideo::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
                          const runner::FrameRecord& record) {
  if (!writer_) writer_.emplace(file_, video_frame_.size(), rate_);
  RepeatFrameUntil(frame.mid_exposure);
  if (frame.mid_exposure % period_ != 0) return;
  DrawOnboard(frame.image.View(), estimate.overlay, record);
  const cv::Mat3b& chase_view = chase_->Render(record.X_WB, record.pad_is_covered);
  chase_view.copyTo(video_frame_(cv::Rect(cv::Point(video_frame_.cols - chase_view.cols, 0), chase_view.size())));
  DrawCaption(video_frame_.rowRange(kHeight_px, video_frame_.rows),
              VideoCaption(record, time_.ToSeconds(frame.mid_exposure)), CaptionColor(record.status));
  writer_->Write(video_frame_);
}

void FlightVideo::Finish() {
  if (!writer_) return;
  RepeatFrameUntil(last_tick_ + 1);
  writer_->Finish();
}

}  // namespace touchdown::report
