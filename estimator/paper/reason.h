#pragma once

#include <string_view>

namespace touchdown::estimator::paper {

/// Reason why a frame has no usable pose: the first step that failed.
enum class Reason {
  kNoComponent,  ///< No connected component is large enough to be classified.
  kNoCircle,     ///< No component inside the image border is classified as a circle.
  kNoH,          ///< No component is classified as the letter.
  kNoPair,       ///< No letter satisfies the geometric constraint with a circle (Sec. IV-A.4).
  kNoEllipse,    ///< No pair yields an ellipse and a pose, or no pair passes the template match.
  kOutlier,      ///< The pose jumps from the previous ones (Sec. IV-C.2). Only this reason has the status rejected.
};

/// Name of a reason in FrameResult::reason: "no_component", "no_circle", "no_h", "no_pair", "no_ellipse" or "outlier".
std::string_view Name(Reason reason);

}  // namespace touchdown::estimator::paper
