#include "scenarios/training/classifier_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "models/random_stream.h"

namespace touchdown::training {
namespace {

std::vector<float> RandomInput(int size, models::RandomStream& random) {
  std::vector<float> input(static_cast<std::size_t>(size));
  for (float& value : input) value = random.Bernoulli(0.3) ? 0.0F : static_cast<float>(random.Uniform());
  return input;
}

TEST(Perceptron, HasOneWeightForEachConnectionAndOneBiasForEachUnit) {
  EXPECT_EQ(Perceptron::Shape{}.parameters(), 196 * 20 + 20 + 20 * 3 + 3);
}

TEST(Perceptron, GivesEqualPosteriorsWithoutWeights) {
  const Perceptron network(Perceptron::Shape{4, 3, 3});
  for (const double posterior : network.Posteriors(std::vector<float>{1, 0, 1, 1}))
    EXPECT_DOUBLE_EQ(posterior, 1.0 / 3.0);
}

TEST(Perceptron, ComputesAKnownNetworkByHand) {
  Perceptron network(Perceptron::Shape{2, 1, 2});
  const std::vector<double> parameters{2.0, -1.0, 0.5, 3.0, -1.0, 0.25, 0.0};
  std::copy(parameters.begin(), parameters.end(), network.parameters().begin());
  const double hidden = 1.0 / (1.0 + std::exp(-(2.0 * 0.5 - 1.0 * 1.0 + 0.5)));
  const double first = std::exp(3.0 * hidden + 0.25), second = std::exp(-hidden);
  const std::vector<double> posterior = network.Posteriors(std::vector<float>{0.5F, 1.0F});
  EXPECT_NEAR(posterior[0], first / (first + second), 1e-15);
  EXPECT_NEAR(posterior[1], second / (first + second), 1e-15);
}

TEST(Perceptron, StaysFiniteForHugeActivations) {
  Perceptron network(Perceptron::Shape{1, 1, 2});
  for (double& parameter : network.parameters()) parameter = 1e4;
  network.parameters()[2] = -1e4;
  const std::vector<double> posterior = network.Posteriors(std::vector<float>{1.0F});
  EXPECT_NEAR(posterior[0] + posterior[1], 1.0, 1e-12);
  std::vector<double> gradient(network.parameters().size(), 0.0);
  EXPECT_TRUE(std::isfinite(network.Backpropagate(std::vector<float>{1.0F}, 0, 1.0, gradient)));
}

TEST(Perceptron, ComputesTheGradientOfItsLoss) {
  models::RandomStream random(3, "perceptron test");
  for (int trial = 0; trial < 10; ++trial) {
    Perceptron network = Perceptron::Random({12, 5, 3}, static_cast<std::uint64_t>(trial));
    for (double& parameter : network.parameters()) parameter += 0.3 * random.Normal();
    const std::vector<float> input = RandomInput(12, random);
    const int target = trial % 3;
    std::vector<double> gradient(network.parameters().size(), 0.0), unused(gradient.size(), 0.0);
    const double loss = network.Backpropagate(input, target, 1.0, gradient);
    EXPECT_NEAR(loss, -std::log(network.Posteriors(input)[static_cast<std::size_t>(target)]), 1e-12);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      const double step = 1e-5, value = network.parameters()[i];
      network.parameters()[i] = value + step;
      const double above = network.Backpropagate(input, target, 1.0, unused);
      network.parameters()[i] = value - step;
      const double below = network.Backpropagate(input, target, 1.0, unused);
      network.parameters()[i] = value;
      EXPECT_NEAR(gradient[i], (above - below) / (2.0 * step), 1e-8) << "parameter " << i;
    }
  }
}

TEST(Perceptron, ScalesLossAndGradientByTheWeight) {
  models::RandomStream random(5, "perceptron test");
  const Perceptron network = Perceptron::Random({6, 4, 3}, 1);
  const std::vector<float> input = RandomInput(6, random);
  std::vector<double> once(network.parameters().size(), 0.0), thrice = once;
  const double loss = network.Backpropagate(input, 1, 1.0, once);
  EXPECT_NEAR(network.Backpropagate(input, 1, 3.0, thrice), 3.0 * loss, 1e-12);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(thrice[i], 3.0 * once[i], 1e-12);
}

TEST(Perceptron, AddsGradientsOfSeveralSamples) {
  models::RandomStream random(4, "perceptron test");
  const Perceptron network = Perceptron::Random({6, 4, 3}, 1);
  const std::vector<float> first = RandomInput(6, random), second = RandomInput(6, random);
  std::vector<double> both(network.parameters().size(), 0.0), one = both, other = both;
  network.Backpropagate(first, 0, 1.0, both);
  network.Backpropagate(second, 2, 1.0, both);
  network.Backpropagate(first, 0, 1.0, one);
  network.Backpropagate(second, 2, 1.0, other);
  for (std::size_t i = 0; i < both.size(); ++i) EXPECT_NEAR(both[i], one[i] + other[i], 1e-15);
}

TEST(Perceptron, DrawsInitialWeightsFromTheSeed) {
  const Perceptron::Shape shape;
  const Perceptron a = Perceptron::Random(shape, 7), b = Perceptron::Random(shape, 7), c = Perceptron::Random(shape, 8);
  EXPECT_TRUE(std::equal(a.parameters().begin(), a.parameters().end(), b.parameters().begin()));
  EXPECT_FALSE(std::equal(a.parameters().begin(), a.parameters().end(), c.parameters().begin()));
  for (const double weight : a.hidden_weights()) EXPECT_LE(std::abs(weight), 1.0 / 14.0);
}

}  // namespace
}  // namespace touchdown::training
