#include "estimator/paper/reason.h"

#include <stdexcept>

namespace touchdown::estimator::paper {

std::string_view Name(Reason reason) {
  switch (reason) {
    case Reason::kNoComponent:
      return "no_component";
    case Reason::kNoCircle:
      return "no_circle";
    case Reason::kNoH:
      return "no_h";
    case Reason::kNoPair:
      return "no_pair";
    case Reason::kNoEllipse:
      return "no_ellipse";
    case Reason::kOutlier:
      return "outlier";
  }
  throw std::logic_error("unknown reason");
}

}  // namespace touchdown::estimator::paper
