#include "scenarios/experiments/flight_group.h"

#include <algorithm>
#include <numeric>

#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

std::vector<double> ValuesIn(const std::vector<Json>& objects, const std::string& name) {
  std::vector<double> values;
  for (const Json& object : objects) {
    if (object.contains(name)) values.push_back(object.at(name).get<double>());
  }
  return values;
}

}  // namespace

FlightGroup::FlightGroup(const Measured& measured, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) flights_.push_back(measured.at(id));
}

int FlightGroup::ended_as_expected() const {
  return static_cast<int>(std::count_if(flights_.begin(), flights_.end(),
                                        [](const Json& flight) { return flight.at("as_expected").get<bool>(); }));
}

int FlightGroup::false_pads() const {
  const std::vector<double> frames = Values("estimate.false_pads");
  return static_cast<int>(std::accumulate(frames.begin(), frames.end(), 0.0));
}

std::vector<double> FlightGroup::Values(const std::string& name) const { return ValuesIn(flights_, name); }

std::vector<double> FlightGroup::Errors(const std::string& reference, const std::string& key) const {
  std::vector<Json> errors;
  for (const Json& flight : flights_) errors.push_back(flight.at(reference));
  return ValuesIn(errors, key);
}

std::optional<double> FlightGroup::MeanError(const std::string& reference, const std::string& key) const {
  const std::vector<double> errors = Errors(reference, key);
  return errors.empty() ? std::nullopt : std::optional(util::Mean(errors));
}

std::vector<std::string> FlightGroup::ErrorRow(const std::string& name, const std::string& reference) const {
  std::vector<std::string> cells{name};
  for (const char* key : kErrorKeys) cells.push_back(util::FixedOrNone(MeanError(reference, key), 2));
  return cells;
}

ComparedQuantity FlightGroup::Failures(const std::string& which) const {
  return {.quantity = which + ": flights that failed",
          .unit = "",
          .published = 0.0,
          .ours = count() - ended_as_expected(),
          .spread = fmt::format("of {}; {} frames with a false pad", count(), false_pads()),
          .why = "Flights that did not end with the expected outcome; the paper reports none."};
}

std::vector<std::string> ErrorHead(const std::string& first) {
  return {first, "XY, mm", "Z, mm", "roll, deg", "pitch, deg", "yaw, deg"};
}

}  // namespace touchdown::experiments
