#include "scenarios/report/flight_video.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "scenarios/report/annotated_frame.h"
#include "sim/dynamics/world.h"

namespace touchdown::report {
namespace {

constexpr int kMostPicturesPerSecond = 30;
constexpr int kHeight_px = 480;
constexpr int kWidestOnboard_px = 854;
constexpr int kCaption_px = 32;
const cv::Vec3b kNothing(40, 40, 40);

int PicturesSkipped(int camera_hz) { return (camera_hz + kMostPicturesPerSecond - 1) / kMostPicturesPerSecond; }

/// The camera's frame as large as its place in the film.
cv::Size OnboardSize(const models::CameraModel& camera) {
  const double scale = std::min(static_cast<double>(kHeight_px) / camera.height_px,
                                static_cast<double>(kWidestOnboard_px) / camera.width_px);
  const auto scaled = [scale](int px) { return std::max(1, static_cast<int>(std::lround(scale * px))); };
  return {scaled(camera.width_px), scaled(camera.height_px)};
}

int Even(int px) { return px + px % 2; }

std::string VideoCaption(const runner::FrameRecord& record, double time_s) {
  return fmt::format("{:6.2f} s   {}   {}   {:.2f} m high", time_s, Name(record.phase),
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
      period_(scenario.time.PeriodOf(scenario.camera.rate_hz) * PicturesSkipped(scenario.camera.rate_hz)),
      rate_{.pictures = scenario.camera.rate_hz, .seconds = PicturesSkipped(scenario.camera.rate_hz)} {}

void FlightVideo::OnStart(const sim::World& world) {
  chase_ = std::make_unique<sim::ChaseView>(world.model(), vehicle_);
  const int width_px = Even(OnboardSize(camera_).width) + chase_->view().width_px;
  picture_ = cv::Mat3b(kHeight_px + kCaption_px, width_px);
  picture_ = kNothing;
}

void FlightVideo::OnImu(const models::ImuSample& sample, bool /*at_rest*/) { newest_ = std::max(newest_, sample.tick); }

void FlightVideo::HoldUntil(models::Tick tick) {
  while (writer_->count() * period_ < tick) writer_->Write(picture_);
}

void FlightVideo::DrawOnboard(const models::ImageView& image, const estimator::Overlay& overlay,
                              const runner::FrameRecord& record) {
  FrameAnnotation annotation{
      .overlay = overlay, .pad_px = record.pad_px, .X_WC = {}, .axis_length_m = pad_.outer_radius_m};
  if (record.status == estimator::FrameStatus::kOk) annotation.X_WC = record.pose->X_WB * X_BC_;
  const cv::Size size = OnboardSize(camera_);
  const cv::Rect place({0, (kHeight_px - size.height) / 2}, size);
  cv::resize(AnnotateFrame(image, camera_, annotation), picture_(place), size, 0.0, 0.0,
             size.width < camera_.width_px ? cv::INTER_AREA : cv::INTER_LINEAR);
}

void FlightVideo::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
                          const runner::FrameRecord& record) {
  if (!writer_) writer_.emplace(file_, picture_.size(), rate_);
  HoldUntil(frame.mid_exposure);
  if (frame.mid_exposure % period_ != 0) return;
  DrawOnboard(frame.image.View(), estimate.overlay, record);
  const cv::Mat3b& seen_from_outside = chase_->Render(record.X_WB, record.pad_is_covered);
  seen_from_outside.copyTo(
      picture_(cv::Rect(cv::Point(picture_.cols - seen_from_outside.cols, 0), seen_from_outside.size())));
  DrawCaption(picture_.rowRange(kHeight_px, picture_.rows), VideoCaption(record, time_.ToSeconds(frame.mid_exposure)),
              CaptionColor(record.status));
  writer_->Write(picture_);
}

void FlightVideo::Finish() {
  if (!writer_) return;
  HoldUntil(newest_ + 1);
  writer_->Finish();
}

}  // namespace touchdown::report
