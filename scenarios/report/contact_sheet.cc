#include "scenarios/report/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "scenarios/report/annotated_frame.h"

namespace touchdown::report {
namespace {

constexpr std::size_t kMaxStoredFrames = 48;
constexpr std::size_t kColumns = 4;
constexpr std::size_t kTiles = 12;
constexpr int kMaxTileWidth_px = 480;
constexpr int kMaxTileHeight_px = 720;

std::string TileCaption(const runner::FrameRecord& record, double time_s) {
  return fmt::format("{:6.2f} s  {:.2f} m  {}  {}", time_s, record.X_WB.translation().z(), Name(record.phase),
                     estimator::ReasonOrStatus(record.status, record.reason));
}

/// Size of a camera frame scaled to the largest tile.
cv::Size TileSize(const models::CameraModel& camera) {
  const double scale = std::min(static_cast<double>(kMaxTileWidth_px) / camera.width_px,
                                static_cast<double>(kMaxTileHeight_px) / camera.height_px);
  return {std::max(1, static_cast<int>(std::lround(scale * camera.width_px))),
          std::max(1, static_cast<int>(std::lround(scale * camera.height_px)))};
}

}  // namespace

ContactSheet::ContactSheet(const models::CameraModel& camera, const models::TimeBase& time)
    : camera_(camera), time_(time), tile_(TileSize(camera)) {}

void ContactSheet::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
                           const runner::FrameRecord& record) {
  if (count_++ % stride_ != 0) return;
  stored_.push_back({frame.image, estimate.overlay, record});
  if (stored_.size() < kMaxStoredFrames) return;
  // Keeps every second frame and doubles the stride, so that the stored frames stay evenly spaced.
  for (std::size_t i = 1; 2 * i < stored_.size(); ++i) stored_[i] = std::move(stored_[2 * i]);
  stored_.resize((stored_.size() + 1) / 2);
  stride_ *= 2;
}

std::vector<std::size_t> ContactSheet::Selection() const {
  const std::size_t tiles = std::min(kTiles, stored_.size());
  std::vector<std::size_t> selection;
  for (std::size_t i = 0; i < tiles; ++i) {
    selection.push_back(tiles == 1 ? 0 : (i * (stored_.size() - 1) + (tiles - 1) / 2) / (tiles - 1));
  }
  return selection;
}

cv::Mat ContactSheet::Tile(const StoredFrame& frame) const {
  cv::Mat3b image =
      AnnotateFrame(frame.image.View(), camera_, {.overlay = frame.overlay, .pad_px = frame.record.pad_px, .X_WC = {}});
  DrawCaption(image.rowRange(0, CaptionHeight(image.size())),
              TileCaption(frame.record, time_.ToSeconds(frame.record.mid_exposure)), CaptionColor(frame.record.status));
  cv::Mat tile;
  cv::resize(image, tile, tile_, 0.0, 0.0, cv::INTER_AREA);
  return tile;
}

std::optional<std::string> ContactSheet::Png() const {
  if (stored_.empty()) return std::nullopt;
  const std::vector<std::size_t> selection = Selection();
  const int rows = static_cast<int>((selection.size() + kColumns - 1) / kColumns);
  cv::Mat sheet(rows * tile_.height, static_cast<int>(kColumns) * tile_.width, CV_8UC3, cv::Scalar(40, 40, 40));
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const cv::Point corner(static_cast<int>(i % kColumns) * tile_.width, static_cast<int>(i / kColumns) * tile_.height);
    Tile(stored_[selection[i]]).copyTo(sheet(cv::Rect(corner, tile_)));
  }
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", sheet, png)) throw std::runtime_error("OpenCV cannot encode the contact sheet");
  return std::string(png.begin(), png.end());
}

}  // namespace touchdown::report
