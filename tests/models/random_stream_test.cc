#include "models/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

namespace touchdown::models {
namespace {

/// Expected values are from an independent implementation of SplitMix64 and the 64-bit Mersenne twister in another
/// language.
TEST(RandomStream, GivesTheSameBitsEverywhere) {
  RandomStream imu(1, "imu.noise"), scene(42, "scene"), nameless(0, "");
  EXPECT_EQ(imu.Bits(), 0x1b7867232b0a31cbULL);
  EXPECT_EQ(imu.Bits(), 0x19f837e7fe635b3cULL);
  EXPECT_EQ(imu.Bits(), 0xc371ccd6f88d7a59ULL);
  EXPECT_EQ(scene.Bits(), 0xf4394cc31a9bf555ULL);
  EXPECT_EQ(scene.Bits(), 0xd63cb14dad5908edULL);
  EXPECT_EQ(nameless.Bits(), 0xe472a21d82b9e8c8ULL);
}

TEST(RandomStream, DiffersForEverySeedAndName) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    for (const std::string name : {"imu", "imu.noise", "imu.bias", "scene", "wind", "a", "b", "ab", "ba"}) {
      first.insert(RandomStream(seed, name).Bits());
    }
  }
  EXPECT_EQ(first.size(), 200U * 9U);
}

TEST(RandomStream, IsUncorrelatedWithItsNeighbors) {
  constexpr int kCount = 20000;
  const auto correlation = [](RandomStream a, RandomStream b) {
    double sum = 0.0;
    for (int i = 0; i < kCount; ++i) sum += a.Normal() * b.Normal();
    return sum / kCount;
  };
  const double five_sigma = 5.0 / std::sqrt(static_cast<double>(kCount));
  EXPECT_LT(std::abs(correlation(RandomStream(1, "imu"), RandomStream(2, "imu"))), five_sigma);
  EXPECT_LT(std::abs(correlation(RandomStream(1, "imu"), RandomStream(1, "wind"))), five_sigma);
  EXPECT_GT(correlation(RandomStream(1, "imu"), RandomStream(1, "imu")), 0.9);
}

TEST(RandomStream, IsUniformOverItsInterval) {
  RandomStream random(1, "test");
  std::array<int, 20> bins{};
  constexpr int kCount = 200000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.Uniform(-2.0, 3.0);
    ASSERT_GE(x, -2.0);
    ASSERT_LT(x, 3.0);
    ++bins[static_cast<std::size_t>((x + 2.0) / 5.0 * 20.0)];
  }
  double chi2 = 0.0;
  for (const int bin : bins) chi2 += std::pow(bin - kCount / 20.0, 2) / (kCount / 20.0);
  EXPECT_LT(chi2, 45.0) << "19 degrees of freedom";
}

TEST(RandomStream, DrawsEveryIntegerWithEqualProbability) {
  RandomStream random(2, "test");
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) {
    const int value = random.UniformInt(-3, 3);
    ASSERT_GE(value, -3);
    ASSERT_LE(value, 3);
    ++counts[static_cast<std::size_t>(value + 3)];
  }
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
  EXPECT_EQ(random.UniformInt(5, 5), 5);
}

TEST(RandomStream, HasTheMomentsOfANormalDistribution) {
  RandomStream random(3, "test");
  constexpr int kCount = 400000;
  double m1 = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.Normal();
    m1 += x / kCount;
    m2 += x * x / kCount;
    m3 += x * x * x / kCount;
    m4 += x * x * x * x / kCount;
  }
  EXPECT_NEAR(m1, 0.0, 0.01);
  EXPECT_NEAR(m2, 1.0, 0.01);
  EXPECT_NEAR(m3, 0.0, 0.03);
  EXPECT_NEAR(m4, 3.0, 0.08);
}

TEST(RandomStream, DrawsAVectorInTheOrderOfItsAxes) {
  RandomStream vector(4, "test"), scalar(4, "test");
  const Eigen::Vector3d v = vector.NormalVector3();
  EXPECT_EQ(v.x(), scalar.Normal());
  EXPECT_EQ(v.y(), scalar.Normal());
  EXPECT_EQ(v.z(), scalar.Normal());
}

TEST(RandomStream, DrawsWithTheGivenProbability) {
  RandomStream random(5, "test");
  int hits = 0;
  for (int i = 0; i < 100000; ++i) hits += random.Bernoulli(0.3);
  EXPECT_NEAR(hits, 30000, 800);
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(random.Bernoulli(0.0));
    EXPECT_TRUE(random.Bernoulli(1.0));
  }
}

}  // namespace
}  // namespace touchdown::models
