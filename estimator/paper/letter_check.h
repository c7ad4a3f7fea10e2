#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/paper/components.h"
#include "models/landing_pad.h"

namespace touchdown::estimator {

/// A shape's mean place and its spread, the covariance of its points.
struct ShapeMoments {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Identity();
};

/// Of the component's pixels, px. Each is a square, so that the spread is never singular.
ShapeMoments MomentsOf(const ComponentSet& components, const Component& component);

struct LetterCheckConfig {
  /// Least correlation with the described H. Smaller values let letters that are nearly an H pass, larger ones refuse an
  /// H under strong perspective, of few pixels or with a mark that touches it.
  double least_resemblance = 0.75;
  /// How far the letter's size within the ring may leave the described one, as a factor, in any direction.
  double largest_size_error = 1.25;

  /// Throws InputError when the resemblance is not within (0, 1), or the error not finite and at least 1.
  void Validate() const;
};

/// Whether a component is the H of the pad as described: the geometric constraint of Sec. IV-A.4 on shapes instead of
/// boxes. A view is taken for affine within the H. What else lies within the ring is not looked at.
class LetterCheck {
 public:
  /// `pad` and `config` must be valid.
  explicit LetterCheck(const models::LandingPad& pad, const LetterCheckConfig& config = {});

  /// Whether the letter resembles the described H and has its size. `moments` are the letter's and `ring_shape` is
  /// Ellipse::Shape() of the ring's outer boundary, in the same pixels.
  bool Passes(const ComponentSet& components, const Component& letter, const ShapeMoments& moments,
              const Eigen::Matrix2d& ring_shape) const;

  /// Correlation, at most 1, of the component with the described H, both brought to the same spread in all directions
  /// and turned to where they are most alike.
  double Resemblance(const ComponentSet& components, const Component& letter) const;

  /// How far the letter's size leaves the H's, as a factor, in the worse direction: 1 where its spread, seen in the shape
  /// of the ring's ellipse, is the described one.
  double SizeError(const ShapeMoments& letter, const Eigen::Matrix2d& ring_shape) const;

 private:
  LetterCheckConfig config_;
  Eigen::Vector2d size_ratios_;  // Of the H's spreads along and across over the ring's radius, the smaller one first.
  std::vector<float> expected_;  // The H's black on a polar grid, less its mean.
  double expected_norm_;
};

}  // namespace touchdown::estimator
