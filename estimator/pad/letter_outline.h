#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/landing_pad.h"

namespace touchdown::estimator::pad {

/// Points about every `spacing_m` along the outline of the pad's H, in W.
std::vector<Eigen::Vector2d> LetterOutline(const models::LandingPad& pad, double spacing_m);

/// Of a point in the plane of W from the outline of the pad's H, m.
double DistanceFromLetter(const models::LandingPad& pad, const Eigen::Vector2d& p_W);

}  // namespace touchdown::estimator::pad
