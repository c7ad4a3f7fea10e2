#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace touchdown::training {

/// A multilayer perceptron with one hidden layer of logistic units and a softmax output (Sec. IV-A.3), in double
/// precision, and the gradient of its loss by backpropagation (Rumelhart et al., 1986).
class Perceptron {
 public:
  struct Shape {
    int inputs = 196;
    int hidden = 20;
    int outputs = 3;

    /// Number of weights and biases of both layers.
    int parameters() const { return (inputs + 1) * hidden + (hidden + 1) * outputs; }

    friend bool operator==(const Shape&, const Shape&) = default;
  };

  /// Sets all weights and biases to 0.
  explicit Perceptron(const Shape& shape);

  /// Draws weights uniformly from +-1/sqrt(fan-in) with the stream "classifier.weights" of `seed`. Biases are 0.
  static Perceptron Random(const Shape& shape, std::uint64_t seed);

  const Shape& shape() const { return shape_; }

  /// All parameters: hidden weights [input][hidden], hidden biases, output weights [hidden][output], output biases.
  std::span<double> parameters() { return parameters_; }
  std::span<const double> parameters() const { return parameters_; }

  std::span<const double> hidden_weights() const;
  std::span<const double> hidden_biases() const;
  std::span<const double> output_weights() const;
  std::span<const double> output_biases() const;

  /// Posterior probability of each class; the sum is 1. `input` has shape().inputs values.
  std::vector<double> Posteriors(std::span<const float> input) const;

  /// Returns the weighted cross-entropy -weight * ln(posterior of `target`), in nats. Adds its gradient with respect to
  /// parameters() to `gradient`.
  double Backpropagate(std::span<const float> input, int target, double weight, std::span<double> gradient) const;

  /// Returns the network with all parameters rounded to single precision, as in the C code.
  Perceptron Rounded() const;

 private:
  struct Activations {
    std::vector<double> hidden;
    std::vector<double> output;
  };
  Activations Forward(std::span<const float> input) const;

  Shape shape_;
  std::vector<double> parameters_;
};

}  // namespace touchdown::training
