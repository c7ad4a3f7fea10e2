#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "estimator/pad/conic_pose.h"
#include "models/landing_pad.h"

namespace touchdown::estimator::pad {

/// Residual of the artwork within the ring against the pad description, for a pose of the pad.
struct TemplateResidual {
  double rms_m = 0.0;      ///< RMS distance of the edge points from the artwork.
  std::size_t points = 0;  ///< Number of edge points.
};

/// Residual of the ring's inner edge and the letter's outline, projected onto the pad's plane at `pose`.
///
/// `ring_inner` and `letter` are edge points in the normalized image (x / z, y / z). On the plane the inner edge must
/// be a circle of the inner radius, and the outline must match the letter at its best rotation. Distances are limited
/// to half a stroke, because a marking that touches the letter has no information about the pose. The true one of the
/// two pose hypotheses of a circle (Sec. IV-C.1) has the smaller residual: the outer circle has the same image at both,
/// the artwork within it does not. Without points the result is zero.
TemplateResidual ResidualOfTemplate(std::span<const Eigen::Vector2d> ring_inner,
                                    std::span<const Eigen::Vector2d> letter, const models::LandingPad& pad,
                                    const CirclePose& pose);

/// Probability that the pose with the larger residual is the true one of two poses.
///
/// The distances are assumed to be normal with unknown sigma, and both poses equally likely a priori. Because points
/// have common errors (blur, lens, paper that is not flat), they count as ten independent points regardless of their
/// number.
double WrongBranchProbability(const TemplateResidual& smaller, const TemplateResidual& larger);

}  // namespace touchdown::estimator::pad
