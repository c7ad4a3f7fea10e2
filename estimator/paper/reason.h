#pragma once

#include <string_view>

namespace touchdown::estimator::paper {

/// Why a frame gives no usable pose: the first step that failed.
enum class Reason {
  kNoComponent,  ///< No connected component is large enough to be classified.
  kNoCircle,     ///< No component was classified as a circle that the image's border does not cut.
  kNoH,          ///< No component was classified as a letter H.
  kNoPair,       ///< No H satisfies the geometric constraint with a circle (Sec. IV-A.4).
  kNoEllipse,    ///< No pair's ring gave an ellipse and a pose, or none passed the template check.
  kOutlier,      ///< The pose jumps from the previous ones (Sec. IV-C.2); the only reason to reject one.
};

/// "no_component", "no_circle", "no_h", "no_pair", "no_ellipse" or "outlier": FrameResult::reason.
std::string_view Name(Reason reason);

}  // namespace touchdown::estimator::paper
