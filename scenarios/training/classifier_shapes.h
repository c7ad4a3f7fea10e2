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

/// True geometry of a ring or letter printed on the floor, of the pad or of a distractor.
struct GroundShape {
  estimator::paper::ComponentClass label = estimator::paper::ComponentClass::kOther;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Center of the bounding box of the ink, in W.
  double yaw = 0.0;                                      ///< Rotation of its axes from W, rad.
  double radius_m = 0.0;                                 ///< Distance from the center to the farthest ink.
  std::vector<Eigen::Vector2d> hull_m;                   ///< Convex hull of the ink, in W.
  double ink_fraction = 0.0;                             ///< Area of the ink divided by the area of the hull.
  double gap_m = 0.0;  ///< Diameter of the largest white disc in the hull; of the largest ink disc for a solid shape.
};

/// Finds all rings and letters of a scene: first ring and letter of the pad, then lone rings and letters of its kind.
std::vector<GroundShape> FindGroundShapes(const sim::Scene& scene);

/// Projection of a shape into the image.
struct ProjectedShape {
  cv::Rect2d box;          ///< Bounding box, px; pixel (u, v) covers [u - 0.5, u + 0.5] x [v - 0.5, v + 0.5].
  cv::Rect2d visible_box;  ///< Part of `box` inside the image; empty when outside.
  double gap = 0.0;        ///< GroundShape::gap_m along its most foreshortened direction, px.
  double obliquity = 0.0;  ///< Angle between the ray to the center and the floor normal, rad.
  double hull_area = 0.0;  ///< Area of the convex hull of the whole shape, px^2.
  double ink_area = 0.0;   ///< Area of the ink, px^2; equal to hull_area for a solid shape.
};

/// Projects a shape; nullopt when a part is behind the camera or outside the valid radius of the distortion model.
std::optional<ProjectedShape> Project(const GroundShape& shape, const models::CameraModel& camera,
                                      const Eigen::Isometry3d& X_WC);

}  // namespace touchdown::training
