#include "tests/support/photo_surfaces.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "models/angles.h"
#include "tests/support/photo_floors.h"

namespace touchdown::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using models::kPi;
using models::RandomStream;

constexpr int kCell_px = 8;  ///< Spacing of the grid of rays; pixels in between are interpolated.

/// Points on sheet and floor that each pixel of the supersampled image views, and the irradiance of the paper relative
/// to that of a flat sheet.
struct Views {
  cv::Mat2f sheet_m, floor_m;
  cv::Mat1f lambert;
};

cv::Mat Fine(const cv::Mat& coarse, cv::Size size) {
  cv::Mat fine;
  cv::resize(coarse, fine, coarse.size() * kCell_px, 0, 0, cv::INTER_LINEAR);
  return fine(cv::Rect({kCell_px, kCell_px}, size)).clone();
}

Views CastRays(const Photograph& photo, const PhotoPaper& paper, int samples, const Vector3d& to_light) {
  const cv::Size size(photo.camera.width_px * samples, photo.camera.height_px * samples);
  const cv::Size cells(size.width / kCell_px + 3, size.height / kCell_px + 3);
  cv::Mat2f sheet(cells), floor(cells);
  cv::Mat1f lambert(cells);
  const Eigen::Isometry3d& X_WC = photo.X_WC;
  for (int row = 0; row < cells.height; ++row) {
    for (int column = 0; column < cells.width; ++column) {
      const Vector2d fine((column - 1) * kCell_px + 0.5 * (kCell_px - 1), (row - 1) * kCell_px + 0.5 * (kCell_px - 1));
      const Vector2d pixel = (fine + Vector2d::Constant(0.5)) / samples - Vector2d::Constant(0.5);
      const auto ray_C = photo.camera.Ray(pixel);
      Vector3d ray_W = X_WC.linear() * ray_C.value_or(Vector3d::UnitZ());
      ray_W.z() = std::min(ray_W.z(), -0.02 * ray_W.norm());  // Rays above the horizon hit the floor too.
      const auto at_height = [&](double z) {
        return Vector2d((X_WC.translation() + ray_W * ((z - X_WC.translation().z()) / ray_W.z())).head<2>());
      };
      const Vector2d on_floor = at_height(0.0);
      Vector2d on_paper = on_floor;
      if (on_floor.norm() < 5.0 * photo.pad.outer_radius_m) {
        for (int n = 0; n < 14; ++n) on_paper = 0.5 * (on_paper + at_height(paper.Height(on_paper)));
      }
      const Vector2d on_sheet = paper.SheetPoint(on_paper);
      sheet(row, column) = {static_cast<float>(on_sheet.x()), static_cast<float>(on_sheet.y())};
      floor(row, column) = {static_cast<float>(on_floor.x()), static_cast<float>(on_floor.y())};
      lambert(row, column) = static_cast<float>(std::max(0.2, paper.Normal(on_paper).dot(to_light) / to_light.z()));
    }
  }
  return {Fine(sheet, size), Fine(floor, size), Fine(lambert, size)};
}

/// Maps each point to A * point + b, for cv::remap.
cv::Mat2f Mapped(const cv::Mat2f& points, const cv::Matx22f& A, const cv::Vec2f& b) {
  cv::Mat2f mapped;
  cv::transform(points, mapped, cv::Matx23f(A(0, 0), A(0, 1), b[0], A(1, 0), A(1, 1), b[1]));
  return mapped;
}

/// Image values at the positions of `map`, scaled to 0 to 1.
cv::Mat1f Sampled(const cv::Mat1b& image, const cv::Mat2f& map, int border) {
  cv::Mat1b levels;
  cv::remap(image, levels, map, cv::noArray(), cv::INTER_LINEAR, border);
  cv::Mat1f fractions;
  levels.convertTo(fractions, CV_32F, 1.0 / 255.0);
  return fractions;
}

cv::Mat1f SampledFloor(const Photograph& photo, const cv::Mat2f& floor_m, RandomStream& random) {
  const double scale = kFloorSide_px / (photo.pad.outer_radius_m * random.Uniform(8.0, 16.0));
  const double free_radius = 0.55 * std::hypot(photo.pad.sheet_length_m, photo.pad.sheet_width_m) * scale;
  const cv::Mat1b floor = DrawFloor(photo.conditions.floor, free_radius, random);
  const double angle = random.Uniform(-kPi, kPi);
  const auto c = static_cast<float>(scale * std::cos(angle)), s = static_cast<float>(scale * std::sin(angle));
  const cv::Mat2f map = Mapped(floor_m, {c, -s, s, c}, {kFloorSide_px / 2.0F, kFloorSide_px / 2.0F});
  cv::Mat1f reflectance = Sampled(floor, map, cv::BORDER_REFLECT_101);
  cv::pow(reflectance, 2.2, reflectance);
  return reflectance;
}

/// Shadow of the paper on the floor.
cv::Mat1f Shade(const cv::Mat1f& covered) {
  cv::Mat1f shade;
  const int shift = std::max(1, covered.rows / 150);
  const cv::Mat move = (cv::Mat_<double>(2, 3) << 1, 0, shift, 0, 1, shift);
  cv::warpAffine(covered, shade, move, covered.size());
  cv::blur(shade, shade, {2 * shift + 1, 2 * shift + 1});
  return shade;
}

}  // namespace

PhotoSurfaces VisibleSurfaces(const Photograph& photo, const Artwork& art, const PhotoPaper& paper, int samples,
                              RandomStream& random) {
  const Vector3d to_light = Vector3d(random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8), 1.0).normalized();
  const Views views = CastRays(photo, paper, samples, to_light);
  const auto scale = static_cast<float>(art.px_per_m);
  const cv::Mat2f sheet_map =
      Mapped(views.sheet_m, {0.0F, -scale, -scale, 0.0F},
             {0.5F * static_cast<float>(art.ink.cols - 1), 0.5F * static_cast<float>(art.ink.rows - 1)});
  const cv::Mat1b whole(art.ink.size(), photo.subject.starts_with("floor") ? 0 : 255);
  const cv::Mat1f covered = Sampled(whole, sheet_map, cv::BORDER_CONSTANT);
  const cv::Mat1f inked = Sampled(art.ink, sheet_map, cv::BORDER_CONSTANT);
  cv::Mat1f floor = SampledFloor(photo, views.floor_m, random);
  floor = floor.mul(1.0 - 0.4 * Shade(covered));
  const double white = random.Uniform(0.68, 0.9), black = random.Uniform(0.035, 0.11);
  const cv::Mat1f sheet = white - (white - black) * inked;
  PhotoSurfaces surfaces;
  surfaces.reflectance = floor + covered.mul(sheet - floor);
  surfaces.toner = inked.mul(covered);
  surfaces.lambert = views.lambert;
  return surfaces;
}

}  // namespace touchdown::tests
