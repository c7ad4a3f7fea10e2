#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown::estimator {

/// Bounding box in pixels: columns [u, u + width), rows [v, v + height).
struct PixelBox {
  int u = 0, v = 0, width = 0, height = 0;

  bool operator==(const PixelBox&) const = default;
};

/// Shapes that a strategy found in a frame, for drawings and logs. No decision depends on them. Reports draw a shape
/// according to its role and need no knowledge of the strategy. Each strategy defines its own names.
struct Overlay {
  /// Meaning of a shape, which determines its color. Shapes of a later role are drawn over those of an earlier role.
  enum class Role {
    kOther,    ///< Something that is not the pad: red.
    kOutline,  ///< An outline of the pad, such as its ring: green.
    kMarking,  ///< A marking on the pad, such as its letter: blue.
    kFit,      ///< A curve fitted to the image: yellow.
  };
  struct Box {
    PixelBox box;  ///< Raw px.
    Role role = Role::kOther;
    std::string name;
    std::optional<double> probability;  ///< Probability that the shape is what `name` says.
  };
  struct Ellipse {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< Undistorted px, at the camera's own focal length.
    Eigen::Vector2d semi_axes = Eigen::Vector2d::Zero();
    double angle = 0.0;  ///< Angle of the major axis from +u towards +v, rad, (-pi/2, pi/2].
    Role role = Role::kFit;
    std::string name;
  };
  struct Polyline {
    std::vector<Eigen::Vector2d> points;  ///< Raw px.
    bool closed = false;                  ///< Whether the last point is connected to the first.
    Role role = Role::kFit;
    std::string name;
  };
  struct Label {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< Left end of the text's baseline, raw px.
    std::string text;
    Role role = Role::kOther;
  };

  std::vector<Box> boxes;
  std::vector<Ellipse> ellipses;
  std::vector<Polyline> polylines;
  std::vector<Label> labels;

  /// The first ellipse named `name`; nullptr if there is none.
  const Ellipse* FindEllipse(std::string_view name) const {
    for (const Ellipse& ellipse : ellipses) {
      if (ellipse.name == name) return &ellipse;
    }
    return nullptr;
  }
};

}  // namespace touchdown::estimator
