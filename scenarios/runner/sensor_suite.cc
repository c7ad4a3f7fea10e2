#include "scenarios/runner/sensor_suite.h"

#include <tuple>
#include <type_traits>

namespace touchdown::runner {
namespace {

template <typename Sensor>
Sensor MakeSensor(const typename Sensor::Config& config, const sim::World& world, const models::TimeBase& time,
                  std::uint64_t seed) {
  if constexpr (std::is_constructible_v<Sensor, decltype(config), decltype(world), decltype(time), std::uint64_t>) {
    return Sensor(config, world, time, seed);
  } else {
    return Sensor(config, time, seed);
  }
}

template <typename... Sensor>
std::tuple<Sensor...> MakeSensors(SensorList<Sensor...>, const LoggedSensors::Configs& configs, const sim::World& world,
                                  const models::TimeBase& time, std::uint64_t seed) {
  return {MakeSensor<Sensor>(std::get<typename Sensor::Config>(configs), world, time, seed)...};
}

template <typename Sensor>
void SampleOne(Sensor& sensor, const sim::TrueState& truth, LoggedSensors::Records& records) {
  if (const auto reading = sensor.Sample(truth)) {
    std::get<std::vector<SensorRecord<Sensor>>>(records).push_back({*reading, truth.X_WB});
  }
}

}  // namespace

SensorSuite::SensorSuite(const LoggedSensors::Configs& configs, const sim::World& world, const models::TimeBase& time,
                         std::uint64_t seed)
    : sensors_(MakeSensors(LoggedSensors(), configs, world, time, seed)) {}

void SensorSuite::Sample(const sim::TrueState& truth) {
  std::apply([&](auto&... sensor) { (SampleOne(sensor, truth, records_), ...); }, sensors_);
}

}  // namespace touchdown::runner
