#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "models/random_stream.h"
#include "scenarios/training/classifier_network.h"

namespace touchdown::training {

/// Input of the network and its true class.
struct TrainingSample {
  std::vector<float> input;
  int target = 0;
};

/// Settings of the training: backpropagation with mini-batches in random order, gradient descent with momentum, and
/// cross-entropy with one-hot targets. All classes have equal weight, independent of their number of samples.
struct TrainingConfig {
  int hidden_units = 20;
  int max_epochs = 160;
  int patience_epochs = 160;  ///< Training stops after this number of epochs without improvement.
  int batch_size = 16;
  double learning_rate = 0.2;  ///< Initial rate; decays geometrically to 1/50 over max_epochs.
  double momentum = 0.9;
  double weight_decay = 1e-5;  ///< L2 regularization of the weights, not of the biases.

  /// Throws InputError when a count is not positive or a rate is out of range.
  void Validate() const;
};

/// Losses of one epoch.
struct EpochReport {
  int epoch = 0;
  double training_loss = 0.0;    ///< Mean weighted cross-entropy during the epoch, nats.
  double validation_loss = 0.0;  ///< BalancedLoss after the epoch.
};

struct TrainingResult {
  Perceptron network;  ///< Network with the smallest validation loss, rounded to single precision.
  int best_epoch = 0;
  double validation_loss = 0.0;
};

/// Callbacks of the training; each may be empty.
struct TrainingHooks {
  /// Data augmentation: returns a variation of the input with the same class. Called for each use of a sample.
  std::function<std::vector<float>(const std::vector<float>& input, models::RandomStream& random)> vary;
  /// Called after each epoch. It may throw to stop.
  std::function<void(const EpochReport&)> progress;
};

/// Class-balanced cross-entropy of the network, nats: the mean over all samples of a class, averaged over the classes
/// that have samples.
double BalancedLoss(const Perceptron& network, std::span<const TrainingSample> samples);

/// Trains a network; the samples define its number of inputs and outputs. The same samples, config and seed give
/// bit-identical weights on the same type of CPU. Throws std::invalid_argument when a set is empty or inputs differ in
/// size, and InputError for an invalid config.
TrainingResult Train(std::span<const TrainingSample> training, std::span<const TrainingSample> validation,
                     const TrainingConfig& config, std::uint64_t seed, const TrainingHooks& hooks = {});

}  // namespace touchdown::training
