#include "scenarios/report/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace touchdown::scenarios {
namespace {

constexpr std::size_t kMostKept = 48;
constexpr std::size_t kColumns = 4;
constexpr std::size_t kTiles = 12;
constexpr int kWidestTile_px = 480;
constexpr int kHighestTile_px = 720;

// Blue, green, red.
const cv::Scalar kGreen(60, 190, 60), kBlue(230, 110, 30), kRed(60, 60, 220), kOrange(0, 140, 255),
    kYellow(0, 230, 255), kWhite(255, 255, 255), kBlack(0, 0, 0);

cv::Scalar ColourOf(estimator::FrameTrace::Label label) {
  switch (label) {
    case estimator::FrameTrace::Label::kCircle:
      return kGreen;
    case estimator::FrameTrace::Label::kH:
      return kBlue;
    case estimator::FrameTrace::Label::kOther:
      break;
  }
  return kRed;
}

/// The ellipse was fitted to undistorted points: bends it back to where it is in the raw frame.
void DrawEllipse(cv::Mat& picture, const models::CameraModel& camera, const estimator::FrameTrace::Ellipse& ellipse,
                 const cv::Scalar& colour) {
  constexpr int kPoints = 90;
  constexpr int kShift = 4;
  std::vector<cv::Point> points;
  for (int i = 0; i < kPoints; ++i) {
    const double t = 2.0 * models::kPi * i / kPoints;
    const Eigen::Vector2d along(std::cos(ellipse.angle), std::sin(ellipse.angle)), across(-along.y(), along.x());
    const Eigen::Vector2d undistorted =
        ellipse.center + ellipse.semi_axes.x() * std::cos(t) * along + ellipse.semi_axes.y() * std::sin(t) * across;
    const Eigen::Vector2d raw = camera.PixelFromNormalized(camera.Distort(camera.NormalizedFromPixel(undistorted)));
    points.emplace_back(static_cast<int>(std::lround(raw.x() * (1 << kShift))),
                        static_cast<int>(std::lround(raw.y() * (1 << kShift))));
  }
  cv::polylines(picture, points, true, colour, 1, cv::LINE_AA, kShift);
}

void DrawCaption(cv::Mat& picture, const FrameRecord& record, double time_s) {
  const std::string height = fmt::format("{:.2f} m", record.X_WB.translation().z());
  const std::string caption =
      fmt::format("{:6.2f} s  {}  {}  {}", time_s, height, Name(record.phase), Name(record.status));
  cv::rectangle(picture, {0, 0}, {picture.cols, 26}, kBlack, cv::FILLED);
  const cv::Scalar colour = record.status == estimator::FrameStatus::kOk ? kWhite : kYellow;
  cv::putText(picture, caption, {8, 19}, cv::FONT_HERSHEY_SIMPLEX, 0.58, colour, 1, cv::LINE_AA);
}

/// The camera's frame, scaled to fit.
cv::Size TileSize(const models::CameraModel& camera) {
  const double scale = std::min(static_cast<double>(kWidestTile_px) / camera.width_px,
                                static_cast<double>(kHighestTile_px) / camera.height_px);
  return {std::max(1, static_cast<int>(std::lround(scale * camera.width_px))),
          std::max(1, static_cast<int>(std::lround(scale * camera.height_px)))};
}

}  // namespace

cv::Mat AnnotateFrame(const models::ImageView& image, const models::CameraModel& camera,
                      const estimator::FrameTrace& trace, const FrameRecord& record, double time_s) {
  // OpenCV has no read-only header; the picture is a copy.
  const cv::Mat grey(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                     static_cast<std::size_t>(image.stride));
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  // Interesting labels last, so that they lie on top.
  using Label = estimator::FrameTrace::Label;
  for (const Label label : {Label::kOther, Label::kCircle, Label::kH}) {
    for (const auto& component : trace.components) {
      if (component.label != label) continue;
      cv::rectangle(picture, cv::Rect(component.u, component.v, component.width, component.height), ColourOf(label),
                    label == Label::kOther ? 1 : 2);
    }
  }
  if (trace.ring_outer) DrawEllipse(picture, camera, *trace.ring_outer, kYellow);
  if (trace.ring_inner) DrawEllipse(picture, camera, *trace.ring_inner, kYellow);
  if (trace.letter) DrawEllipse(picture, camera, *trace.letter, kYellow);
  if (record.pad_px) {
    const cv::Point center(static_cast<int>(std::lround(record.pad_px->x())),
                           static_cast<int>(std::lround(record.pad_px->y())));
    cv::drawMarker(picture, center, kOrange, cv::MARKER_CROSS, 40, 3, cv::LINE_AA);
  }
  DrawCaption(picture, record, time_s);
  return picture;
}

ContactSheet::ContactSheet(const models::CameraModel& camera, const models::TimeBase& time)
    : camera_(camera), time_(time), tile_(TileSize(camera)) {}

void ContactSheet::OnFrame(const models::CameraFrame& frame, const estimator::FrameEstimate& estimate,
                           const FrameRecord& record) {
  if (count_++ % stride_ != 0) return;
  kept_.push_back({frame.image, estimate.trace, record});
  if (kept_.size() < kMostKept) return;
  // Every other one: the stride doubles, and what is kept stays evenly spread.
  for (std::size_t i = 1; 2 * i < kept_.size(); ++i) kept_[i] = std::move(kept_[2 * i]);
  kept_.resize((kept_.size() + 1) / 2);
  stride_ *= 2;
}

std::vector<std::size_t> ContactSheet::Selection() const {
  const std::size_t tiles = std::min(kTiles, kept_.size());
  std::vector<std::size_t> selection;
  for (std::size_t i = 0; i < tiles; ++i) {
    selection.push_back(tiles == 1 ? 0 : (i * (kept_.size() - 1) + (tiles - 1) / 2) / (tiles - 1));
  }
  return selection;
}

cv::Mat ContactSheet::Tile(const Kept& kept) const {
  const double time_s = time_.ToSeconds(kept.record.mid_exposure);
  cv::Mat tile;
  cv::resize(AnnotateFrame(kept.image.View(), camera_, kept.trace, kept.record, time_s), tile, tile_, 0.0, 0.0,
             cv::INTER_AREA);
  return tile;
}

std::optional<std::string> ContactSheet::Png() const {
  if (kept_.empty()) return std::nullopt;
  const std::vector<std::size_t> selection = Selection();
  const int rows = static_cast<int>((selection.size() + kColumns - 1) / kColumns);
  cv::Mat sheet(rows * tile_.height, static_cast<int>(kColumns) * tile_.width, CV_8UC3, cv::Scalar(40, 40, 40));
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const cv::Point corner(static_cast<int>(i % kColumns) * tile_.width, static_cast<int>(i / kColumns) * tile_.height);
    Tile(kept_[selection[i]]).copyTo(sheet(cv::Rect(corner, tile_)));
  }
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", sheet, png)) throw std::runtime_error("OpenCV cannot encode the contact sheet");
  return std::string(png.begin(), png.end());
}

}  // namespace touchdown::scenarios
