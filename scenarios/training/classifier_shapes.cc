#include "scenarios/training/classifier_shapes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "models/pad_outline.h"
#include "sim/scene/artwork.h"

namespace touchdown::training {
namespace {

using estimator::paper::ComponentClass;

constexpr double kTexelsPerMeter = 1000.0;

/// Printed sheet on the floor: its ink and its pose.
struct Sheet {
  cv::Mat1b ink;  ///< 255 for ink; column 0 is at the -X edge of the sheet, row 0 at its +Y edge.
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double yaw = 0.0;
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();

  Eigen::Vector2d PointAt(double column, double row) const {
    const Eigen::Vector2d p_S((column / ink.cols - 0.5) * size_m.x(), (0.5 - row / ink.rows) * size_m.y());
    return position_m + Eigen::Rotation2Dd(yaw) * p_S;
  }
};

cv::Size Texels(const Eigen::Vector2d& size_m) {
  return {static_cast<int>(std::ceil(size_m.x() * kTexelsPerMeter)),
          static_cast<int>(std::ceil(size_m.y() * kTexelsPerMeter))};
}

cv::Mat1b WhiteInsideHull(const std::vector<cv::Point>& hull, const cv::Mat1b& ink) {
  cv::Mat1b white = cv::Mat1b::zeros(ink.size());
  cv::fillConvexPoly(white, hull, cv::Scalar(255));
  white &= ~ink;
  return white;
}

/// Diameter of the largest disc inside the nonzero texels, m.
double LargestDiscDiameter(const cv::Mat1b& texels) {
  cv::Mat1f distance;
  cv::distanceTransform(texels, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  double largest = 0.0;
  cv::minMaxLoc(distance, nullptr, &largest);
  return 2.0 * largest / kTexelsPerMeter;
}

GroundShape MakeGroundShape(ComponentClass label, const Sheet& sheet) {
  std::vector<cv::Point> texels, hull;
  cv::findNonZero(sheet.ink, texels);
  cv::convexHull(texels, hull);
  GroundShape shape;
  shape.label = label;
  shape.yaw = sheet.yaw;
  shape.ink_fraction = std::min(1.0, static_cast<double>(texels.size()) / std::max(1.0, cv::contourArea(hull)));
  shape.gap_m = LargestDiscDiameter(shape.ink_fraction < 1.0 ? WhiteInsideHull(hull, sheet.ink) : sheet.ink);
  const cv::Rect box = cv::boundingRect(hull);
  shape.position_m = sheet.PointAt(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  for (const cv::Point& texel : hull) {
    shape.hull_m.push_back(sheet.PointAt(texel.x + 0.5, texel.y + 0.5));
    shape.radius_m = std::max(shape.radius_m, (shape.hull_m.back() - shape.position_m).norm());
  }
  return shape;
}

Sheet PadSheet(const models::LandingPad& pad, bool ring) {
  Sheet sheet;
  sheet.size_m = {pad.sheet_length_m, pad.sheet_width_m};
  const cv::Size size = Texels(sheet.size_m);
  sheet.ink = cv::Mat1b::zeros(size);
  const models::PadOutline outline(pad);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const Eigen::Vector2d p_W = sheet.PointAt(column + 0.5, row + 0.5);
      const bool on_ring = p_W.norm() >= pad.inner_radius_m() && outline.IsBlack(p_W);
      if (ring ? on_ring : outline.IsLetter(p_W)) sheet.ink(row, column) = 255;
    }
  }
  return sheet;
}

Sheet ItemSheet(const sim::SceneItem& item) {
  Sheet sheet;
  sheet.position_m = item.position_m;
  sheet.yaw = item.yaw;
  sheet.size_m = item.size_m.head<2>();
  const cv::Size size = Texels(sheet.size_m);
  const cv::Mat1b print = sim::PaintSheet(item, size.width, size.height);
  double darkest = 0.0, brightest = 0.0;
  cv::minMaxLoc(print, &darkest, &brightest);
  sheet.ink = print < 0.5 * (darkest + brightest);
  return sheet;
}

}  // namespace

std::vector<GroundShape> FindGroundShapes(const sim::Scene& scene) {
  std::vector<GroundShape> shapes;
  if (scene.config.pad) {
    shapes.push_back(MakeGroundShape(ComponentClass::kCircle, PadSheet(scene.pad, true)));
    shapes.push_back(MakeGroundShape(ComponentClass::kH, PadSheet(scene.pad, false)));
  }
  const bool solid = scene.pad.letter() == models::PadLetter::kRectangle;
  const auto letter_kind = solid ? sim::SceneItem::Kind::kRectangle : sim::SceneItem::Kind::kLetterH;
  for (const sim::SceneItem& item : scene.items) {
    const bool ring = item.kind == sim::SceneItem::Kind::kRing;
    if (!ring && item.kind != letter_kind) continue;
    shapes.push_back(MakeGroundShape(ring ? ComponentClass::kCircle : ComponentClass::kH, ItemSheet(item)));
  }
  return shapes;
}

std::optional<ProjectedShape> Project(const GroundShape& shape, const models::CameraModel& camera,
                                      const Eigen::Isometry3d& X_WC) {
  const Eigen::Isometry3d X_CW = X_WC.inverse();
  std::vector<cv::Point2f> outline;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  for (const Eigen::Vector2d& p_W : shape.hull_m) {
    const std::optional<Eigen::Vector2d> pixel = camera.Project(X_CW * Eigen::Vector3d(p_W.x(), p_W.y(), 0.0));
    if (!pixel) return std::nullopt;
    low = low.cwiseMin(*pixel);
    high = high.cwiseMax(*pixel);
    outline.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
  }
  ProjectedShape result;
  result.box = cv::Rect2d(low.x(), low.y(), high.x() - low.x(), high.y() - low.y());
  result.visible_box = result.box & cv::Rect2d(-0.5, -0.5, camera.width_px, camera.height_px);
  const Eigen::Vector3d ray_W(shape.position_m.x() - X_WC.translation().x(),
                              shape.position_m.y() - X_WC.translation().y(), -X_WC.translation().z());
  result.obliquity = std::acos(std::clamp(-ray_W.z() / ray_W.norm(), -1.0, 1.0));
  result.gap = shape.gap_m * camera.fx_px * std::pow(std::cos(result.obliquity), 2) / ray_W.norm();
  result.hull_area = cv::contourArea(outline);
  result.ink_area = shape.ink_fraction * result.hull_area;
  return result;
}

}  // namespace touchdown::training
