#include "models/describe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace touchdown::models {
namespace {

using ::testing::StrEq;
using ::testing::ThrowsMessage;

struct Wheel {
  double radius_m = 0.3;
};

struct Cart {
  double mass_kg = 20.0;
  double payload_kg = 5.0;
  std::optional<double> speed_m_s;
  std::vector<double> axle_m = {0.0, 1.0};
  int seats = 2;
  Wheel wheel;
  std::vector<Wheel> spares = {{}, {}};
};

void Describe(ConfigVisitor& v, Wheel& w) { v.Number({"radius_m", "Radius."}, w.radius_m, kMeter, kPositive); }

void Describe(ConfigVisitor& v, Cart& c) {
  v.Number({"mass_kg", "Mass."}, c.mass_kg, kKilogram, Between(1.0, 100.0));
  v.Number({"payload_kg", "Payload."}, c.payload_kg, kKilogram, kAny);
  v.OptionalNumber({"speed_m_s", "Speed."}, c.speed_m_s, kMeterPerSecond, PositiveUpTo(0.05));
  v.Numbers({"axle_m", "Axle."}, {&c.axle_m[0], &c.axle_m[1]}, kMeter, kNotNegative);
  v.Integer({"seats", "Seats."}, c.seats, Between(1, 100000));
  v.Keys({"wheel", "Wheel."}, c.wheel);
  v.Items({"spares", "Spare wheels."}, c.spares);
  v.Check("payload_kg", [&c] {
    if (c.payload_kg > c.mass_kg) throw InputError("must not be above mass_kg");
  });
  v.Check("", [&c] {
    if (c.spares.size() > 4) throw InputError("too many wheels");
  });
}

Cart With(const std::function<void(Cart&)>& change) {
  Cart cart;
  change(cart);
  return cart;
}

TEST(ValidateConfig, AcceptsValuesWithinTheirRanges) {
  EXPECT_NO_THROW(ValidateConfig(Cart{}));
  EXPECT_NO_THROW(ValidateConfig(With([](Cart& c) { c.mass_kg = 100.0; })));
  EXPECT_NO_THROW(ValidateConfig(With([](Cart& c) { c.speed_m_s = 0.05; })));
}

TEST(ValidateConfig, ReportsKeyRangeAndValue) {
  const struct {
    std::function<void(Cart&)> change;
    const char* message;
  } cases[] = {
      {[](Cart& c) { c.mass_kg = 100.5; }, "mass_kg: must be from 1 to 100, is 100.5"},
      {[](Cart& c) { c.payload_kg = NAN; }, "payload_kg: must be a finite number, is nan"},
      {[](Cart& c) { c.payload_kg = -INFINITY; }, "payload_kg: must be a finite number, is -inf"},
      {[](Cart& c) { c.speed_m_s = 0.0; }, "speed_m_s: must be above 0 and at most 0.05, is 0"},
      {[](Cart& c) { c.axle_m[1] = -1e-6; }, "axle_m.1: must be at least 0, is -1e-06"},
      {[](Cart& c) { c.seats = 0; }, "seats: must be from 1 to 100000, is 0"},
      {[](Cart& c) { c.wheel.radius_m = 0.0; }, "wheel.radius_m: must be above 0, is 0"},
      {[](Cart& c) { c.spares[1].radius_m = 0.0; }, "spares.1.radius_m: must be above 0, is 0"},
  };
  for (const auto& wrong : cases) {
    const Cart cart = With(wrong.change);
    EXPECT_THAT([&cart] { ValidateConfig(cart); }, ThrowsMessage<InputError>(StrEq(wrong.message)));
  }
}

TEST(ValidateConfig, RunsChecksAcrossKeys) {
  EXPECT_THAT([] { ValidateConfig(With([](Cart& c) { c.payload_kg = 21.0; })); },
              ThrowsMessage<InputError>(StrEq("payload_kg: must not be above mass_kg")));
  EXPECT_THAT([] { ValidateConfig(With([](Cart& c) { c.spares.resize(5); })); },
              ThrowsMessage<InputError>(StrEq("too many wheels")));
}

TEST(Range, FormatsItsRequirement) {
  EXPECT_EQ(Between(-0.0001, 36000.0).Sentence(), "must be from -0.0001 to 36000");
  EXPECT_EQ(Between(3, 3).Sentence(), "must be 3");
  EXPECT_EQ(Range{.max = 1e-5}.Sentence(), "must be at most 1e-05");
  EXPECT_EQ(kNotNegative.Sentence(), "must be at least 0");
}

}  // namespace
}  // namespace touchdown::models
