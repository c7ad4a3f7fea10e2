#include "scenarios/training/classifier_network.h"

#include <algorithm>
#include <cmath>

#include "models/random_stream.h"

namespace touchdown::training {
namespace {

std::size_t Size(int count) { return static_cast<std::size_t>(count); }

void AddScaled(double scale, const double* from, int count, double* to) {
  for (int i = 0; i < count; ++i) to[i] += scale * from[i];
}

void Softmax(std::vector<double>& values) {
  const double largest = *std::max_element(values.begin(), values.end());
  double sum = 0.0;
  for (double& value : values) sum += value = std::exp(value - largest);
  for (double& value : values) value /= sum;
}

}  // namespace

Perceptron::Perceptron(const Shape& shape) : shape_(shape), parameters_(Size(shape.parameters()), 0.0) {}

Perceptron Perceptron::Random(const Shape& shape, std::uint64_t seed) {
  Perceptron network(shape);
  models::RandomStream random(seed, "classifier.weights");
  const auto draw = [&](std::span<const double> layer, int fan_in) {
    const double bound = 1.0 / std::sqrt(static_cast<double>(fan_in));
    double* weights = network.parameters_.data() + (layer.data() - network.parameters_.data());
    for (std::size_t i = 0; i < layer.size(); ++i) weights[i] = random.Uniform(-bound, bound);
  };
  draw(network.hidden_weights(), shape.inputs);
  draw(network.output_weights(), shape.hidden);
  return network;
}

std::span<const double> Perceptron::hidden_weights() const {
  return parameters().subspan(0, Size(shape_.inputs * shape_.hidden));
}

std::span<const double> Perceptron::hidden_biases() const {
  return parameters().subspan(Size(shape_.inputs * shape_.hidden), Size(shape_.hidden));
}

std::span<const double> Perceptron::output_weights() const {
  return parameters().subspan(Size((shape_.inputs + 1) * shape_.hidden), Size(shape_.hidden * shape_.outputs));
}

std::span<const double> Perceptron::output_biases() const { return parameters().last(Size(shape_.outputs)); }

Perceptron::Activations Perceptron::Forward(std::span<const float> input) const {
  Activations result;
  result.hidden.assign(hidden_biases().begin(), hidden_biases().end());
  result.output.assign(output_biases().begin(), output_biases().end());
  for (int i = 0; i < shape_.inputs; ++i) {
    if (input[Size(i)] == 0.0F) continue;
    AddScaled(input[Size(i)], &hidden_weights()[Size(i * shape_.hidden)], shape_.hidden, result.hidden.data());
  }
  for (int j = 0; j < shape_.hidden; ++j) {
    double& unit = result.hidden[Size(j)];
    unit = 1.0 / (1.0 + std::exp(-unit));
    AddScaled(unit, &output_weights()[Size(j * shape_.outputs)], shape_.outputs, result.output.data());
  }
  Softmax(result.output);
  return result;
}

std::vector<double> Perceptron::Posteriors(std::span<const float> input) const { return Forward(input).output; }

double Perceptron::Backpropagate(std::span<const float> input, int target, double weight,
                                 std::span<double> gradient) const {
  const Activations units = Forward(input);
  std::vector<double> output_delta = units.output;
  output_delta[Size(target)] -= 1.0;
  for (double& delta : output_delta) delta *= weight;

  double* output_gradient = gradient.data() + Size((shape_.inputs + 1) * shape_.hidden);
  std::vector<double> hidden_delta(Size(shape_.hidden), 0.0);
  for (int j = 0; j < shape_.hidden; ++j) {
    const double unit = units.hidden[Size(j)];
    const double* weights = &output_weights()[Size(j * shape_.outputs)];
    for (int k = 0; k < shape_.outputs; ++k) hidden_delta[Size(j)] += weights[k] * output_delta[Size(k)];
    hidden_delta[Size(j)] *= unit * (1.0 - unit);
    AddScaled(unit, output_delta.data(), shape_.outputs, output_gradient + j * shape_.outputs);
  }
  AddScaled(1.0, output_delta.data(), shape_.outputs, output_gradient + shape_.hidden * shape_.outputs);

  for (int i = 0; i < shape_.inputs; ++i) {
    if (input[Size(i)] == 0.0F) continue;
    AddScaled(input[Size(i)], hidden_delta.data(), shape_.hidden, gradient.data() + i * shape_.hidden);
  }
  AddScaled(1.0, hidden_delta.data(), shape_.hidden, gradient.data() + shape_.inputs * shape_.hidden);
  return -weight * std::log(std::max(units.output[Size(target)], 1e-300));
}

Perceptron Perceptron::Rounded() const {
  Perceptron result = *this;
  for (double& value : result.parameters_) value = static_cast<float>(value);
  return result;
}

}  // namespace touchdown::training
