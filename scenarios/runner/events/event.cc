#include "scenarios/runner/events/event.h"

#include <array>
#include <string_view>
#include <utility>

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {
namespace {

using Kinds = std::make_index_sequence<std::variant_size_v<EventKind>>;

template <std::size_t... i>
constexpr auto NamesOfKinds(std::index_sequence<i...>) {
  return std::array{std::variant_alternative_t<i, EventKind>::kName...};
}
constexpr auto kKindNames = NamesOfKinds(Kinds());

/// "push (a force and a torque), wind (a new mean wind), ...".
template <std::size_t... i>
std::string DocOfKinds(std::index_sequence<i...>) {
  std::string doc;
  const auto add = [&doc](std::string_view name, std::string_view meaning) {
    doc += (doc.empty() ? "" : ", ") + std::string(name) + " (" + std::string(meaning) + ")";
  };
  (add(std::variant_alternative_t<i, EventKind>::kName, std::variant_alternative_t<i, EventKind>::kDoc), ...);
  return doc;
}

template <std::size_t... i>
EventKind KindAt(std::size_t index, std::index_sequence<i...>) {
  EventKind kind;
  ((index == i ? static_cast<void>(kind.emplace<i>()) : void()), ...);
  return kind;
}

}  // namespace

void Event::Check(const Scenario& scenario) const {
  std::visit([&](const auto& own) { own.Check(scenario, duration_s); }, kind);
}

std::string Event::Label() const {
  return std::visit([](const auto& own) { return own.Label(); }, kind);
}

bool Event::has_duration() const {
  return std::visit([](const auto& own) { return own.kHasDuration; }, kind);
}

void Describe(models::ConfigVisitor& v, Event& event) {
  static const std::string kinds = "Kind of event: " + DocOfKinds(Kinds()) + ".";
  v.Number({"at_s", "Start of the event, from the start of the flight.", true}, event.at_s, models::kSecond,
           models::kTime);
  int index = static_cast<int>(event.kind.index());
  v.Choice({"do", kinds, true}, index, kKindNames);
  if (index >= 0 && index != static_cast<int>(event.kind.index())) {
    event.kind = KindAt(static_cast<std::size_t>(index), Kinds());
  }
  std::visit([&v](auto& own) { own.Describe(v); }, event.kind);
  if (!event.has_duration()) return;
  v.Number({"duration_s", "Duration of the event (not for wind).", true}, event.duration_s, models::kSecond,
           models::kPositiveTime);
}

}  // namespace touchdown::runner
