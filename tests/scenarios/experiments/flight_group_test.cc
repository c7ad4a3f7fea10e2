#include "scenarios/experiments/flight_group.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchdown::experiments {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

/// Two flights with the expected outcome, and one that crashed before the first vision pose.
Measured ThreeFlights() {
  return {{"a_1",
           {{"as_expected", true},
            {"truth", {{"xy_mm", 10.0}, {"z_mm", 1.0}, {"roll_deg", 0.5}, {"pitch_deg", 0.25}, {"yaw_deg", 2.0}}},
            {"estimate.false_pads", 2.0},
            {"flight.max_tilt_deg", 5.0}}},
          {"a_2",
           {{"as_expected", true},
            {"truth", {{"xy_mm", 20.0}, {"z_mm", 3.0}, {"roll_deg", 1.5}, {"pitch_deg", 0.75}, {"yaw_deg", 1.0}}},
            {"estimate.false_pads", 1.0},
            {"flight.max_tilt_deg", 7.0}}},
          {"a_3", {{"as_expected", false}, {"truth", Json::object()}}}};
}

TEST(FlightGroup, AveragesOverTheFlightsThatHaveAnError) {
  const FlightGroup flights(ThreeFlights(), {"a_1", "a_2", "a_3"});
  EXPECT_EQ(flights.count(), 3);
  EXPECT_EQ(flights.ended_as_expected(), 2);
  EXPECT_EQ(flights.false_pads(), 3);
  EXPECT_THAT(flights.Values("flight.max_tilt_deg"), ElementsAre(5.0, 7.0));
  EXPECT_THAT(flights.Errors("truth", "xy_mm"), ElementsAre(10.0, 20.0));
  EXPECT_THAT(flights.MeanError("truth", "xy_mm"), Optional(DoubleEq(15.0)));
  EXPECT_THAT(flights.ErrorRow("all", "truth"), ElementsAre("all", "15.00", "2.00", "1.00", "0.50", "1.50"));
  EXPECT_EQ(flights.ErrorRow("all", "truth").size(), ErrorHead("flight").size());
}

TEST(FlightGroup, PrintsNoneIfNoFlightHasAnError) {
  const FlightGroup crashed(ThreeFlights(), {"a_3"});
  EXPECT_THAT(crashed.Errors("truth", "xy_mm"), IsEmpty());
  EXPECT_EQ(crashed.MeanError("truth", "xy_mm"), std::nullopt);
  EXPECT_THAT(crashed.ErrorRow("crashed", "truth"), ElementsAre("crashed", "none", "none", "none", "none", "none"));
}

TEST(FlightGroup, ComparesTheNumberOfFailuresWithZero) {
  const ComparedQuantity failures = FlightGroup(ThreeFlights(), {"a_1", "a_3"}).Failures("Case");
  EXPECT_THAT(failures.ours, Optional(1.0));
  EXPECT_FALSE(failures.MeetsPublished());
  EXPECT_TRUE(FlightGroup(ThreeFlights(), {"a_1", "a_2"}).Failures("Case").MeetsPublished());
}

}  // namespace
}  // namespace touchdown::experiments
