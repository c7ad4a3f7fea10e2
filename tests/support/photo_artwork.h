#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "models/landing_pad.h"
#include "models/random_stream.h"

namespace touchdown::tests {

/// Ink on a sheet of paper, 0 (none) to 255 (full). Columns run along -Y of the sheet and rows along -X, so that an H
/// is upright. The center of the pad is the center of the image.
struct Artwork {
  cv::Mat1b ink;
  double px_per_m = 0.0;

  Artwork(const models::LandingPad& pad, double px_per_meter);

  cv::Point2d At(double x_m, double y_m) const;                                    ///< Pixel of a point in W.
  void FillPolygon(const std::vector<cv::Point2d>& corners_m, bool black = true);  ///< (x, y) in W.
  void FillBox(double x_m, double y_m, double size_x_m, double size_y_m, double yaw = 0.0);
  void FillRing(double x_m, double y_m, double outer_m, double inner_m);  ///< Keeps the inside of the ring.
  void Line(double x1_m, double y1_m, double x2_m, double y2_m, double width_m);
  /// Draws text whose box is centered at (x, y).
  void Text(const std::string& text, double x_m, double y_m, double height_m, double stroke_fraction, double yaw = 0.0);
};

/// Draws a random pad that fits on its sheet: the nominal one, or one with a thin or thick ring and a small, large,
/// slender or wide H.
models::LandingPad DrawAnyPad(models::RandomStream& random);

/// Prints ring and H of the pad.
void PrintPad(const models::LandingPad& pad, Artwork& art);
/// Prints markings inside the ring; `kind` is one of MarkingKinds().
void PrintMarkings(const models::LandingPad& pad, const std::string& kind, models::RandomStream& random, Artwork& art);
const std::vector<std::string>& MarkingKinds();

/// Prints a distractor; `kind` is one of DistractorKinds(). Kinds that begin with "floor" have no sheet, only a floor.
void PrintDistractor(const models::LandingPad& pad, const std::string& kind, models::RandomStream& random,
                     Artwork& art);
const std::vector<std::string>& DistractorKinds();

}  // namespace touchdown::tests
