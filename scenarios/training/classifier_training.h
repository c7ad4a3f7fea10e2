#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "models/random_stream.h"
#include "scenarios/training/classifier_network.h"

namespace touchdown::training {

/// An input of the network and the class that it should be given.
struct TrainingSample {
  std::vector<float> input;
  int target = 0;
};

/// Standard backpropagation: mini-batches in random order, gradient descent with momentum, 1-of-n targets,
/// cross-entropy, in which all classes count alike however many samples they have.
struct TrainingConfig {
  int hidden_units = 20;
  int max_epochs = 160;
  int patience_epochs = 160;  ///< Ends after so many epochs without a better validation loss.
  int batch_size = 16;
  double learning_rate = 0.2;  ///< On the batch's mean gradient; falls to its fiftieth, by the same factor each epoch.
  double momentum = 0.9;
  double weight_decay = 1e-5;  ///< Adds this times the weight to the gradient; biases are left alone.

  /// Throws InputError when a count is not positive or a rate is out of its range.
  void Validate() const;
};

struct EpochReport {
  int epoch = 0;
  double training_loss = 0.0;    ///< Mean weighted cross-entropy over the epoch, nats.
  double validation_loss = 0.0;  ///< BalancedLoss after the epoch.
};

struct TrainingResult {
  Perceptron network;  ///< Of the best validation loss, rounded to single precision.
  int best_epoch = 0;
  double validation_loss = 0.0;
};

/// What happens around and within a training.
struct TrainingHooks {
  /// Another sample of the same class, made from this one each time that it is shown; empty: the sample itself.
  std::function<std::vector<float>(const std::vector<float>& input, models::RandomStream& random)> vary;
  /// Called after each epoch; it may throw to stop.
  std::function<void(const EpochReport&)> progress;
};

/// Cross-entropy of the network, nats: the mean over the classes present of the mean over each one's samples, so that
/// it does not matter how many samples a class has.
double BalancedLoss(const Perceptron& network, std::span<const TrainingSample> samples);

/// Trains a network of as many inputs and outputs as the samples have. The same samples, config and seed give the same
/// weights, bit for bit, on the same type of CPU. Throws std::invalid_argument when either set is empty or its inputs
/// differ in size.
TrainingResult Train(std::span<const TrainingSample> training, std::span<const TrainingSample> validation,
                     const TrainingConfig& config, std::uint64_t seed, const TrainingHooks& hooks = {});

}  // namespace touchdown::training
