#include "scenarios/runner/event_player.h"

namespace touchdown::runner {

EventPlayer::EventPlayer(std::vector<Event> events, const models::TimeBase& time)
    : events_(std::move(events)), time_(time) {}

void EventPlayer::Apply(models::Tick tick, sim::World& world) {
  EventEffects effects;
  for (const Event& event : events_) {
    const models::Tick begin = time_.FromSeconds(event.at_s);
    const bool has_ended = event.has_duration() && tick >= time_.FromSeconds(event.at_s + event.duration_s);
    if (tick < begin || has_ended) continue;
    const EventTime event_time{
        .begins = tick == begin, .elapsed_s = time_.ToSeconds(tick - begin), .duration_s = event.duration_s};
    std::visit([&](const auto& kind) { kind.Apply(event_time, effects); }, event.kind);
  }
  world.SetPush(effects.force_n, effects.torque_n_m);
  world.SetGust(effects.gust_m_s);
  if (effects.mean_wind_m_s) world.SetWind(*effects.mean_wind_m_s);
  if (effects.pad_is_covered != effects_.pad_is_covered) world.CoverPad(effects.pad_is_covered);
  effects_ = effects;
}

}  // namespace touchdown::runner
