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

constexpr std::size_t kMostKept = 48;
constexpr std::size_t kColumns = 4;
constexpr std::size_t kTiles = 12;
constexpr int kWidestTile_px = 480;
constexpr int kHighestTile_px = 720;

std::string TileCaption(const runner::FrameRecord& record, double time_s) {
  return fmt::format("{:6.2f} s  {:.2f} m  {}  {}", time_s, record.X_WB.translation().z(), Name(record.phase),
                     estimator::ReasonOrStatus(record.status, record.reason));
}

/// The camera's frame, scaled to fit.
cv::Size TileSize(const models::CameraModel& camera) {
  const double scale = std::min(static_cast<double>(kWidestTile_px) / camera.width_px,
                                static_cast<double>(kHighestTile_px) / camera.height_px);
  return {std::max(1, static_cast<int>(std::lround(scale * camera.width_px))),
          std::max(1, static_cast<int>(std::lround(scale * camera.height_px)))};
}

}  // namespace

ContactSheet::ContactSheet(const models::CameraModel& camera, const models::TimeBase& time)
    : camera_(camera), time_(time), tile_(TileSize(camera)) {}

void ContactSheet::OnFrame(const models::CameraFrame& frame, const estimator::FrameResult& estimate,
                           const runner::FrameRecord& record) {
  if (count_++ % stride_ != 0) return;
  kept_.push_back({frame.image, estimate.overlay, record});
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
  cv::Mat3b picture =
      AnnotateFrame(kept.image.View(), camera_, {.overlay = kept.overlay, .pad_px = kept.record.pad_px, .X_WC = {}});
  DrawCaption(picture.rowRange(0, CaptionHeight(picture.size())),
              TileCaption(kept.record, time_.ToSeconds(kept.record.mid_exposure)), CaptionColor(kept.record.status));
  cv::Mat tile;
  cv::resize(picture, tile, tile_, 0.0, 0.0, cv::INTER_AREA);
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

}  // namespace touchdown::report
