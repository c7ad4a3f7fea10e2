#include "scenarios/runner/event_player.h"

namespace touchdown::runner {

EventPlayer::EventPlayer(std::vector<Event> events, const models::TimeBase& time)
    : events_(std::move(events)), time_(time) {}

bool EventPlayer::Acts(const Event& event, models::Tick tick) const {
  return tick >= time_.FromSeconds(event.at_s) && tick < time_.FromSeconds(event.at_s + event.duration_s);
}

void EventPlayer::Apply(models::Tick tick, sim::World& world) {
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero(), torque_n_m = Eigen::Vector3d::Zero();
  bool covered = false;
  frames_are_lost_ = false;
  for (const Event& event : events_) {
    if (event.kind == Event::Kind::kWind && tick == time_.FromSeconds(event.at_s)) world.SetWind(event.velocity_m_s);
    if (event.kind == Event::Kind::kWind || !Acts(event, tick)) continue;
    if (event.kind == Event::Kind::kPush) {
      force_n += event.force_n;
      torque_n_m += event.torque_n_m;
    }
    covered = covered || event.kind == Event::Kind::kCoverPad;
    frames_are_lost_ = frames_are_lost_ || event.kind == Event::Kind::kLoseFrames;
  }
  world.SetPush(force_n, torque_n_m);
  if (covered != pad_is_covered_) world.CoverPad(covered);
  pad_is_covered_ = covered;
}

}  // namespace touchdown::runner
