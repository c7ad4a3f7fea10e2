#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "models/landing_pad.h"
#include "models/random_stream.h"

namespace touchdown::tests {

/// Ink on a sheet of paper: 0 none, 255 full. Columns run along the sheet's -Y, rows along its -X, so that an H stands
/// upright; the pad's center is the middle of the picture.
struct Artwork {
  cv::Mat1b ink;
  double px_per_m = 0.0;

  Artwork(const models::LandingPad& pad, double px_per_meter);

  cv::Point2d At(double x_m, double y_m) const;
  void FillPolygon(const std::vector<cv::Point2d>& corners_m, bool black = true);  ///< (x, y) in W.
  void FillBox(double x_m, double y_m, double size_x_m, double size_y_m, double yaw = 0.0);
  void FillRing(double x_m, double y_m, double outer_m, double inner_m);  ///< What lies inside stays as it is.
  void Line(double x1_m, double y1_m, double x2_m, double y2_m, double width_m);
  /// Its box's center at (x, y), its height in meters.
  void Text(const std::string& text, double x_m, double y_m, double height_m, double stroke_fraction, double yaw = 0.0);
};

/// Any pad that fits its sheet: the nominal one, thin and thick rings, small and large Hs, slender and square ones.
models::LandingPad DrawAnyPad(models::RandomStream& random);

void PrintPad(const models::LandingPad& pad, Artwork& art);
/// `kind` names one of MarkingKinds().
void PrintMarkings(const models::LandingPad& pad, const std::string& kind, models::RandomStream& random, Artwork& art);
const std::vector<std::string>& MarkingKinds();

/// What is not the pad, `kind` being one of DistractorKinds(). The kinds that begin with "floor" print nothing: the
/// floor is all there is.
void PrintDistractor(const models::LandingPad& pad, const std::string& kind, models::RandomStream& random,
                     Artwork& art);
const std::vector<std::string>& DistractorKinds();

}  // namespace touchdown::tests
