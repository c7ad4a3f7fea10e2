#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "estimator/paper/classifier.h"
#include "models/camera_model.h"
#include "sim/scene/scene.h"

namespace touchdown::training {

/// A ring or a letter as the pad's printed on the floor, as the truth has it.
struct GroundShape {
  estimator::paper::ComponentClass label = estimator::paper::ComponentClass::kOther;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Center of its ink's bounding box, in W.
  double yaw = 0.0;                                      ///< Of its axes, from W's.
  double radius_m = 0.0;                                 ///< From there to the farthest ink.
  std::vector<Eigen::Vector2d> hull_m;                   ///< Convex hull of its ink, in W.
  double ink_fraction = 0.0;                             ///< Ink's area over the hull's.
  double gap_m = 0.0;  ///< Diameter of the largest disc of white within the hull; of ink where the shape is solid.
};

/// Every ring and letter of the scene: the pad's two, and the lone ones of the same kinds as they are printed.
std::vector<GroundShape> FindGroundShapes(const sim::Scene& scene);

/// Where a shape appears in the image.
struct ProjectedShape {
  cv::Rect2d box;          ///< Of its ink, px; a pixel at (u, v) covers [u - 0.5, u + 0.5] x [v - 0.5, v + 0.5].
  cv::Rect2d visible_box;  ///< The part of `box` inside the image; empty when it is outside.
  double gap = 0.0;        ///< Of the shape's gap_m, foreshortened in the direction that is worst, px.
  double obliquity = 0.0;  ///< Angle between the ray to the shape's center and the floor's normal, rad.
  double hull_area = 0.0;  ///< Of the whole shape's convex hull, square px.
  double ink_area = 0.0;   ///< Of its ink, square px; as large as hull_area where the shape is solid.
};

/// nullopt when a part of the shape lies behind the camera or beyond the radius at which its distortion folds.
std::optional<ProjectedShape> Project(const GroundShape& shape, const models::CameraModel& camera,
                                      const Eigen::Isometry3d& X_WC);

}  // namespace touchdown::training
