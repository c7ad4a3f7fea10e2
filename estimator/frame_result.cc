#include "estimator/frame_result.h"

#include <stdexcept>

namespace touchdown::estimator {

std::string_view Name(FrameStatus status) {
  switch (status) {
    case FrameStatus::kOk:
      return "ok";
    case FrameStatus::kNotFound:
      return "not_found";
    case FrameStatus::kRejected:
      return "rejected";
  }
  throw std::invalid_argument("unknown frame status");
}

std::string_view ReasonOrStatus(FrameStatus status, std::string_view reason) {
  return reason.empty() ? Name(status) : reason;
}

std::string_view Name(PoseChoice::Reason reason) {
  switch (reason) {
    case PoseChoice::Reason::kGravity:
      return "gravity";
    case PoseChoice::Reason::kArtwork:
      return "artwork";
    case PoseChoice::Reason::kFrontal:
      return "frontal";
  }
  throw std::invalid_argument("unknown reason of a pose choice");
}

}  // namespace touchdown::estimator
