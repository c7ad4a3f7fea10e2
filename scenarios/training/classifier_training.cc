#include "scenarios/training/classifier_training.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::training {
namespace {

constexpr double kFinalRateFactor = 0.02;

Perceptron::Shape NetworkShape(std::span<const TrainingSample> training, std::span<const TrainingSample> validation,
                               int hidden_units) {
  if (training.empty() || validation.empty()) throw std::invalid_argument("both sample sets must not be empty");
  Perceptron::Shape shape{
      .inputs = static_cast<int>(training.front().input.size()), .hidden = hidden_units, .outputs = 0};
  for (const auto& samples : {training, validation}) {
    for (const TrainingSample& sample : samples) {
      if (static_cast<int>(sample.input.size()) != shape.inputs) {
        throw std::invalid_argument("all inputs must have the same size");
      }
      shape.outputs = std::max(shape.outputs, sample.target + 1);
    }
  }
  return shape;
}

void Shuffle(std::vector<std::size_t>& order, models::RandomStream& random) {
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    std::swap(order[i], order[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(i)))]);
  }
}

/// Weight of a sample of each class, so that all classes have equal total weight; the mean over all samples is 1.
std::vector<double> ClassWeights(std::span<const TrainingSample> samples, int classes) {
  std::vector<double> weights(static_cast<std::size_t>(classes), 0.0);
  for (const TrainingSample& sample : samples) weights[static_cast<std::size_t>(sample.target)] += 1.0;
  for (double& weight : weights) {
    if (weight > 0.0) weight = static_cast<double>(samples.size()) / (classes * weight);
  }
  return weights;
}

/// Gradient descent with momentum.
class Descent {
 public:
  Descent(Perceptron& network, std::vector<double> class_weights, const TrainingConfig& config,
          const TrainingHooks& hooks, std::uint64_t seed)
      : network_(network),
        class_weights_(std::move(class_weights)),
        config_(config),
        hooks_(hooks),
        random_(seed, "classifier.variation"),
        gradient_(network.parameters().size(), 0.0),
        velocity_(network.parameters().size(), 0.0) {}

  /// Makes one step along the mean gradient of the batch. Returns the sum of the losses before the step.
  double Step(std::span<const TrainingSample> samples, std::span<const std::size_t> batch, double learning_rate) {
    std::fill(gradient_.begin(), gradient_.end(), 0.0);
    double loss = 0.0;
    for (const std::size_t i : batch) loss += AddGradient(samples[i]);
    AddWeightDecay(static_cast<double>(batch.size()));
    const double scale = learning_rate / static_cast<double>(batch.size());
    const auto parameters = network_.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      velocity_[i] = config_.momentum * velocity_[i] - scale * gradient_[i];
      parameters[i] += velocity_[i];
    }
    return loss;
  }

 private:
  double AddGradient(const TrainingSample& sample) {
    const double weight = class_weights_[static_cast<std::size_t>(sample.target)];
    if (!hooks_.vary) return network_.Backpropagate(sample.input, sample.target, weight, gradient_);
    return network_.Backpropagate(hooks_.vary(sample.input, random_), sample.target, weight, gradient_);
  }

  void AddWeightDecay(double batch_size) {
    const double* first = network_.parameters().data();
    for (const auto& weights : {network_.hidden_weights(), network_.output_weights()}) {
      const auto offset = static_cast<std::size_t>(weights.data() - first);
      for (std::size_t i = 0; i < weights.size(); ++i) {
        gradient_[offset + i] += config_.weight_decay * batch_size * weights[i];
      }
    }
  }

  Perceptron& network_;
  std::vector<double> class_weights_;
  const TrainingConfig& config_;
  const TrainingHooks& hooks_;
  models::RandomStream random_;
  std::vector<double> gradient_;
  std::vector<double> velocity_;
};

}  // namespace

void TrainingConfig::Validate() const {
  if (hidden_units < 1 || max_epochs < 1 || patience_epochs < 1 || batch_size < 1) {
    throw InputError("hidden units, epochs, patience and batch size must be at least 1");
  }
  if (!(learning_rate > 0.0) || !(momentum >= 0.0 && momentum < 1.0) || !(weight_decay >= 0.0)) {
    throw InputError("learning rate must be above 0, momentum at least 0 and below 1, weight decay at least 0");
  }
}

double BalancedLoss(const Perceptron& network, std::span<const TrainingSample> samples) {
  const auto classes = static_cast<std::size_t>(network.shape().outputs);
  std::vector<double> sum(classes, 0.0);
  std::vector<int> count(classes, 0);
  for (const TrainingSample& sample : samples) {
    const auto target = static_cast<std::size_t>(sample.target);
    sum[target] -= std::log(std::max(network.Posteriors(sample.input)[target], 1e-300));
    ++count[target];
  }
  double total = 0.0;
  int present = 0;
  for (std::size_t k = 0; k < classes; ++k) {
    if (count[k] == 0) continue;
    total += sum[k] / count[k];
    ++present;
  }
  return total / present;
}

TrainingResult Train(std::span<const TrainingSample> training, std::span<const TrainingSample> validation,
                     const TrainingConfig& config, std::uint64_t seed, const TrainingHooks& hooks) {
  config.Validate();
  Perceptron network = Perceptron::Random(NetworkShape(training, validation, config.hidden_units), seed);
  Descent descent(network, ClassWeights(training, network.shape().outputs), config, hooks, seed);
  models::RandomStream random(seed, "classifier.order");
  std::vector<std::size_t> order(training.size());
  std::iota(order.begin(), order.end(), std::size_t{0});

  TrainingResult best{
      .network = network.Rounded(), .best_epoch = 0, .validation_loss = BalancedLoss(network, validation)};
  for (int epoch = 1; epoch <= config.max_epochs && epoch - best.best_epoch <= config.patience_epochs; ++epoch) {
    const double progress = static_cast<double>(epoch - 1) / config.max_epochs;
    const double learning_rate = config.learning_rate * std::pow(kFinalRateFactor, progress);
    Shuffle(order, random);
    double loss = 0.0;
    for (std::size_t begin = 0; begin < order.size(); begin += static_cast<std::size_t>(config.batch_size)) {
      const std::size_t count = std::min(static_cast<std::size_t>(config.batch_size), order.size() - begin);
      loss += descent.Step(training, std::span(order).subspan(begin, count), learning_rate);
    }
    Perceptron rounded = network.Rounded();
    const double validation_loss = BalancedLoss(rounded, validation);
    if (hooks.progress) hooks.progress({epoch, loss / static_cast<double>(training.size()), validation_loss});
    if (validation_loss < best.validation_loss) best = {std::move(rounded), epoch, validation_loss};
  }
  return best;
}

}  // namespace touchdown::training
