#include "scenarios/training/classifier_training.h"

#include <gtest/gtest.h>

#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::training {
namespace {

std::vector<TrainingSample> ExclusiveOr() { return {{{0, 0}, 0}, {{0, 1}, 1}, {{1, 0}, 1}, {{1, 1}, 0}}; }

/// Points in a square, labeled by the ring around its center that contains them: not linearly separable.
std::vector<TrainingSample> Rings(int count, std::uint64_t seed) {
  models::RandomStream random(seed, "training test");
  std::vector<TrainingSample> samples;
  while (static_cast<int>(samples.size()) < count) {
    const double x = random.Uniform(-1.0, 1.0), y = random.Uniform(-1.0, 1.0);
    const double radius = x * x + y * y;
    const int ring = radius < 0.25 ? 0 : radius < 0.8 ? 1 : 2;
    samples.push_back({{static_cast<float>(x), static_cast<float>(y)}, ring});
  }
  return samples;
}

double Accuracy(const Perceptron& network, const std::vector<TrainingSample>& samples) {
  int correct = 0;
  for (const TrainingSample& sample : samples) {
    const std::vector<double> posterior = network.Posteriors(sample.input);
    correct += std::max_element(posterior.begin(), posterior.end()) - posterior.begin() == sample.target;
  }
  return static_cast<double>(correct) / static_cast<double>(samples.size());
}

TEST(Training, LearnsTheExclusiveOr) {
  const std::vector<TrainingSample> samples = ExclusiveOr();
  const TrainingConfig config{.hidden_units = 4,
                              .max_epochs = 3000,
                              .patience_epochs = 3000,
                              .batch_size = 4,
                              .learning_rate = 0.5,
                              .weight_decay = 0.0};
  const TrainingResult result = Train(samples, samples, config, 1);
  EXPECT_LT(BalancedLoss(result.network, samples), 0.05);
  EXPECT_EQ(Accuracy(result.network, samples), 1.0);
}

TEST(Training, GeneralizesToNewSamples) {
  const TrainingConfig config{.max_epochs = 300, .patience_epochs = 300, .learning_rate = 0.2, .weight_decay = 0.0};
  const TrainingResult result = Train(Rings(1500, 1), Rings(500, 2), config, 1);
  EXPECT_GT(Accuracy(result.network, Rings(2000, 3)), 0.95);
}

TEST(Training, WeighsAllClassesEqually) {
  std::vector<TrainingSample> samples(900, {{1.0F}, 0});
  samples.resize(1000, {{1.0F}, 1});
  const TrainingConfig config{.max_epochs = 60, .patience_epochs = 60, .learning_rate = 0.05};
  const Perceptron network = Train(samples, samples, config, 1).network;
  EXPECT_NEAR(network.Posteriors(std::vector<float>{1.0F})[0], 0.5, 0.02);
}

TEST(Training, KeepsTheNetworkOfTheBestValidationLoss) {
  std::vector<TrainingSample> noise = Rings(60, 1);
  models::RandomStream random(5, "labels at random");
  for (TrainingSample& sample : noise) sample.target = random.UniformInt(0, 2);
  const std::vector<TrainingSample> validation = Rings(200, 2);
  double smallest = BalancedLoss(Perceptron::Random({2, 20, 3}, 1).Rounded(), validation);
  int epochs = 0;
  const TrainingConfig config{.max_epochs = 400, .patience_epochs = 20, .learning_rate = 0.02};
  const TrainingResult result =
      Train(noise, validation, config, 1, {.vary = {}, .progress = [&](const EpochReport& report) {
                                             smallest = std::min(smallest, report.validation_loss);
                                             epochs = report.epoch;
                                           }});
  EXPECT_NEAR(result.validation_loss, smallest, 1e-8);
  EXPECT_NEAR(BalancedLoss(result.network, validation), smallest, 1e-8);
  EXPECT_EQ(epochs, result.best_epoch + 20);
}

TEST(Training, GivesWeightsThatDependOnlyOnTheSeed) {
  const TrainingConfig config{.max_epochs = 5};
  const auto train = [&](std::uint64_t seed) { return Train(Rings(300, 1), Rings(100, 2), config, seed).network; };
  const Perceptron a = train(1), b = train(1), c = train(2);
  EXPECT_TRUE(std::equal(a.parameters().begin(), a.parameters().end(), b.parameters().begin()));
  EXPECT_FALSE(std::equal(a.parameters().begin(), a.parameters().end(), c.parameters().begin()));
}

TEST(Training, RejectsInvalidSamplesAndSettings) {
  const std::vector<TrainingSample> samples = ExclusiveOr();
  EXPECT_THROW(Train({}, samples, {}, 1), std::invalid_argument);
  EXPECT_THROW(Train(samples, {}, {}, 1), std::invalid_argument);
  EXPECT_THROW(Train(samples, Rings(3, 1), {.batch_size = 0}, 1), InputError);
  EXPECT_THROW(Train(samples, Rings(3, 1), {.learning_rate = 0.0}, 1), InputError);
  EXPECT_THROW(Train(samples, Rings(3, 1), {.momentum = 1.0}, 1), InputError);
  std::vector<TrainingSample> uneven = samples;
  uneven.push_back({{1, 2, 3}, 0});
  EXPECT_THROW(Train(uneven, samples, {}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace touchdown::training
