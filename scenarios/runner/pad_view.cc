#include "scenarios/runner/pad_view.h"

#include <cmath>

#include "models/angles.h"

namespace touchdown::runner {

bool WholeRingInView(const models::CameraModel& camera, const models::LandingPad& pad, const Eigen::Isometry3d& X_WC) {
  constexpr int kPoints = 120;
  const Eigen::Isometry3d X_CW = X_WC.inverse();
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * models::kPi * i / kPoints;
    const Eigen::Vector3d p_W(pad.outer_radius_m * std::cos(angle), pad.outer_radius_m * std::sin(angle), 0.0);
    const std::optional<Eigen::Vector2d> pixel = camera.Project(X_CW * p_W);
    if (!pixel || !camera.Contains(*pixel)) return false;
  }
  return true;
}

}  // namespace touchdown::runner
