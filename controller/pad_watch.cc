#include "controller/pad_watch.h"

namespace touchdown::controller {

void PadWatch::Update(models::Tick tick, std::optional<models::Tick> pad_seen) {
  if (pad_seen.has_value() && pad_seen != newest_) {
    if (!newest_.has_value() || *pad_seen - *newest_ > settings_.lost_after) since_ = pad_seen;
    newest_ = pad_seen;
  }
  lost_ = !newest_.has_value() || tick - *newest_ > settings_.lost_after;
  found_ = !lost_ && *newest_ - *since_ >= settings_.found_after;
  fresh_ = newest_.has_value() && tick - *newest_ <= settings_.fresh_for;
}

}  // namespace touchdown::controller
