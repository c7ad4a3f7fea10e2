// A build without the libraries of ROS bags.
#include <gtest/gtest.h>

#include "models/error.h"
#include "scenarios/datasets/bag_file.h"
#include "scenarios/datasets/flight_bag.h"

namespace touchdown::datasets {
namespace {

template <typename Action>
std::string ErrorOf(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NoBags, SaysThatTheBuildKnowsNone) {
  constexpr const char* kError =
      "bag flight.bag: built without the ROS packages for bags; packages/test.txt lists them";
  EXPECT_EQ(ErrorOf([] { FlightBag({}, "out/flight.bag"); }), kError);
  EXPECT_EQ(ErrorOf([] { BagFile("out/flight.bag", {}); }), kError);
}

}  // namespace
}  // namespace touchdown::datasets
