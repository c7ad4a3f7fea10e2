#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "models/describe.h"
#include "models/pad_marking.h"

namespace touchdown::models {

/// Letter within the ring of a landing pad: an H or a solid rectangle (Sec. IV-C.3).
enum class PadLetter { kH, kRectangle };

/// The landing pad (Sec. III-B): a black ring around a black letter H, centered on a white sheet.
///
/// Frame W has its origin at the pad's center, Z up. The H's long strokes run along X, its cross-bar along Y, and the
/// sheet's long side along X. An H whose two strokes meet, 2 h_stroke_m = h_width_m, is a solid rectangle of h_height_m
/// by h_width_m. A pad may have markings in addition to its H; the default pad has none. PadOutline has the shapes.
struct LandingPad {
  double outer_radius_m = 0.090;
  double ring_width_m = 0.016;
  double h_height_m = 0.100;
  double h_width_m = 0.056;
  double h_stroke_m = 0.016;
  double sheet_length_m = 0.297;  // A4.
  double sheet_width_m = 0.210;
  std::vector<PadMarking> marks;

  double inner_radius_m() const { return outer_radius_m - ring_width_m; }

  /// kRectangle when the strokes meet to within a nanometer, else kH.
  PadLetter letter() const;

  /// Throws InputError, without a file name, for a value out of its range (see Describe), or when the H's strokes
  /// overlap or are as wide as the H is high, the H does not fit inside the ring with a white gap, the ring does not
  /// fit on the sheet, or PadMarking::Validate rejects a marking for the ring's inner radius.
  void Validate() const;

  friend bool operator==(const LandingPad&, const LandingPad&) = default;
};

void Describe(ConfigVisitor& v, LandingPad& pad);

/// True if `yaw` rotated by 180 degrees is nearer to `reference_yaw` than `yaw` itself; both in rad.
bool HalfTurnIsNearer(double yaw, double reference_yaw);

/// Resolves the 180-degree yaw ambiguity: ring and H look the same from X_WB and from X_WB rotated by 180 degrees about
/// W's Z axis (Sec. IV-C.3), whatever markings the pad has. Returns the one whose yaw is nearer to `reference_yaw`,
/// rad.
Eigen::Isometry3d ResolveYawAmbiguity(const Eigen::Isometry3d& X_WB, double reference_yaw);

}  // namespace touchdown::models
