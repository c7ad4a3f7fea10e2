#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "estimator/paper/components.h"
#include "estimator/paper/conic_pose.h"
#include "estimator/paper/undistort_table.h"
#include "models/camera_model.h"
#include "models/landing_pad.h"

namespace touchdown::estimator {

struct LetterCheckConfig {
  /// Least correlation with the described H. Smaller values let letters that are nearly an H pass, larger ones refuse
  /// an H under strong perspective, of few pixels or with a mark that touches it.
  double least_resemblance = 0.80;
  double least_symmetry = 0.75;
  /// How far the letter's size within the ring may leave the described one, as a factor, in any direction.
  double largest_size_error = 1.12;

  /// Throws InputError when the resemblance or the symmetry is not within (0, 1), or the error not finite and at
  /// least 1.
  void Validate() const;
};

/// How components came out of a camera's image: one pixel of theirs is a square of `reduction` pixels of the camera.
struct ComponentView {
  const models::CameraModel& camera;
  const UndistortTable& undistort;
  int reduction = 1;
};

/// Whether a component is the H of the pad as described: the geometric constraint of Sec. IV-A.4 on shapes instead of
/// boxes, in the plane that the ring's ellipse tells. What else lies within the ring is not looked at.
class LetterCheck {
 public:
  /// `pad` and `config` must be valid.
  explicit LetterCheck(const models::LandingPad& pad, const LetterCheckConfig& config = {});

  /// How a component fits the described H on one plane.
  struct Fit {
    /// Correlation, at most 1, both brought to the same spread in all directions, which makes up for paper that is not
    /// quite flat, and turned to where they are most alike. -1 where part of the H's place is not seen.
    double resemblance = -1.0;
    /// Correlation, at most 1, with its own mirror image about either axis of the H, the smaller one: what keeps an N,
    /// an M or a U apart from an H whose strokes are as broad, where blur or few pixels leave little resemblance to
    /// any.
    double symmetry = -1.0;
    /// By how much its spread leaves the described one, as a factor, in the worse of the principal directions.
    double size_error = 1.0;
  };

  /// `letter` is one of `components`.
  Fit FitOn(const CirclePose& ring_pose, const ComponentSet& components, const Component& letter,
            const ComponentView& view) const;

  /// Whether the letter is the H on one of both planes on which the ring may lie.
  bool Passes(const std::array<CirclePose, 2>& ring_poses, const ComponentSet& components, const Component& letter,
              const ComponentView& view) const;

 private:
  LetterCheckConfig config_;
  Eigen::Vector2d sizes_m_;      // Standard deviations of the H's area along its axes, the smaller one first.
  std::vector<float> expected_;  // The H's black on a polar grid, less its mean.
  double expected_norm_;
};

}  // namespace touchdown::estimator
