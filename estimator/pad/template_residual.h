#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "estimator/pad/conic_pose.h"
#include "models/landing_pad.h"

namespace touchdown::estimator::pad {

/// How far what is printed within the ring is from where the pad has it, when the pad is at a pose.
struct TemplateResidual {
  double rms_m = 0.0;
  std::size_t points = 0;
};

/// The ring's inner edge and the H's outline, seen in the normalized image (x / z, y / z), are laid back onto the
/// pad's plane at `pose`, where the one must be a circle of the inner radius and the other the H, turned as fits best.
/// A point's distance counts up to half a stroke: a mark that touches the H says nothing of the pose. Of the two poses
/// of a circle (Sec. IV-C.1) the right one has the smaller residual: the outer circle looks the same from both, what
/// lies within it does not. Without points the residual is 0 of 0.
TemplateResidual ResidualOfTemplate(std::span<const Eigen::Vector2d> ring_inner,
                                    std::span<const Eigen::Vector2d> letter, const models::LandingPad& pad,
                                    const CirclePose& pose);

/// The probability that of two poses the one with the larger residual is right, when a point's distance is normal, its
/// sigma unknown, and both poses were as likely before. Points share their errors (blur, lens, paper that is not flat),
/// so that however many they are they count as ten.
double WrongBranchProbability(const TemplateResidual& smaller, const TemplateResidual& larger);

}  // namespace touchdown::estimator::pad
