#include "estimator/estimator.h"

#include <stdexcept>

namespace touchdown::estimator {

std::string_view Name(FrameStatus status) {
  switch (status) {
    case FrameStatus::kOk:
      return "ok";
    case FrameStatus::kNoComponent:
      return "no_component";
    case FrameStatus::kNoCircle:
      return "no_circle";
    case FrameStatus::kNoH:
      return "no_h";
    case FrameStatus::kNoPair:
      return "no_pair";
    case FrameStatus::kNoEllipse:
      return "no_ellipse";
    case FrameStatus::kOutlier:
      return "outlier";
  }
  throw std::logic_error("a frame status without a name");
}

std::string_view Name(PoseChoice::Reason reason) {
  switch (reason) {
    case PoseChoice::Reason::kGravity:
      return "gravity";
    case PoseChoice::Reason::kPrint:
      return "print";
    case PoseChoice::Reason::kFrontal:
      return "frontal";
  }
  throw std::logic_error("a reason without a name");
}

}  // namespace touchdown::estimator
