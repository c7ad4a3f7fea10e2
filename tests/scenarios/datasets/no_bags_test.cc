// A build without ROS bag support.
#include <gtest/gtest.h>

#include "scenarios/datasets/bag_file.h"
#include "scenarios/datasets/flight_bag.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

using tests::ThrowsInputError;

TEST(NoBags, ReportsThatTheBuildHasNoBagSupport) {
  constexpr const char* kError =
      "bag flight.bag: built without ROS bag support; packages/test.txt lists the required packages";
  EXPECT_THAT([] { FlightBag({}, "out/flight.bag"); }, ThrowsInputError(kError));
  EXPECT_THAT([] { BagFile("out/flight.bag", {}); }, ThrowsInputError(kError));
}

}  // namespace
}  // namespace touchdown::datasets
