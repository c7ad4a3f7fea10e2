#include "scenarios/training/classifier_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

namespace touchdown::training {
namespace {

constexpr int kLineLimit = 118;

constexpr const char* kFunctionBody = R"((const float pattern[INPUTS], float posterior[OUTPUTS]) {
  float hidden[HIDDEN];
  for (int j = 0; j < HIDDEN; ++j) hidden[j] = kHiddenBiases[j];
  for (int i = 0; i < INPUTS; ++i) {
    const float cell = pattern[i];
    if (cell == 0.0f) continue;
    for (int j = 0; j < HIDDEN; ++j) hidden[j] += cell * kHiddenWeights[i][j];
  }
  for (int k = 0; k < OUTPUTS; ++k) posterior[k] = kOutputBiases[k];
  for (int j = 0; j < HIDDEN; ++j) {
    const float unit = 1.0f / (1.0f + expf(-hidden[j]));
    for (int k = 0; k < OUTPUTS; ++k) posterior[k] += unit * kOutputWeights[j][k];
  }
  float largest = posterior[0];
  for (int k = 1; k < OUTPUTS; ++k) largest = posterior[k] > largest ? posterior[k] : largest;
  float sum = 0.0f;
  for (int k = 0; k < OUTPUTS; ++k) {
    posterior[k] = expf(posterior[k] - largest);
    sum += posterior[k];
  }
  for (int k = 0; k < OUTPUTS; ++k) posterior[k] /= sum;
}
)";

std::string FunctionName(models::PadLetter letter) {
  return letter == models::PadLetter::kRectangle ? "TouchdownRectangleClassifierPosteriors"
                                                 : "TouchdownClassifierPosteriors";
}

/// A C literal that reads back as the same float.
std::string Literal(double value) {
  std::string text = fmt::format("{}", static_cast<float>(value));
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

/// "a, b, c" broken into lines, each indented by `indent`.
std::string Lines(std::span<const double> values, const std::string& indent) {
  std::string text = indent;
  std::size_t length = indent.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string word = Literal(values[i]) + (i + 1 < values.size() ? "," : "");
    if (i > 0 && length + 1 + word.size() > kLineLimit) {
      text += "\n" + indent;
      length = indent.size();
    } else if (i > 0) {
      text += " ";
      ++length;
    }
    text += word;
    length += word.size();
  }
  return text + "\n";
}

std::string Vector(const std::string& declaration, std::span<const double> values) {
  return fmt::format("static const float {} = {{\n{}}};\n", declaration, Lines(values, "    "));
}

std::string Matrix(const std::string& declaration, std::span<const double> values, int columns) {
  std::string text = fmt::format("static const float {} = {{\n", declaration);
  const auto step = static_cast<std::size_t>(columns);
  for (std::size_t row = 0; row < values.size(); row += step) {
    text += "    {\n" + Lines(values.subspan(row, step), "        ") + "    },\n";
  }
  return text + "};\n";
}

}  // namespace

std::string ClassifierCode(const Perceptron& network, models::PadLetter letter,
                           const std::vector<std::pair<std::string, std::string>>& provenance) {
  const Perceptron::Shape& shape = network.shape();
  if (shape.inputs != 196 || shape.outputs != 3)
    throw std::invalid_argument("the classifier must have 196 inputs and 3 outputs");
  std::string code = "/* Written by `touchdown train`: see docs/classifier.md. Do not edit.\n";
  for (const auto& [name, value] : provenance) code += fmt::format(" *   {}: {}\n", name, value);
  code += " */\n// clang-format off\n";
  code += "#include \"estimator/paper/classifier_weights.h\"\n\n#include <math.h>\n\n";
  code +=
      fmt::format("enum {{ INPUTS = {}, HIDDEN = {}, OUTPUTS = {} }};\n\n", shape.inputs, shape.hidden, shape.outputs);
  code += Matrix("kHiddenWeights[INPUTS][HIDDEN]", network.hidden_weights(), shape.hidden);
  code += Vector("kHiddenBiases[HIDDEN]", network.hidden_biases());
  code += Matrix("kOutputWeights[HIDDEN][OUTPUTS]", network.output_weights(), shape.outputs);
  code += Vector("kOutputBiases[OUTPUTS]", network.output_biases());
  return code + "\nvoid " + FunctionName(letter) + kFunctionBody;
}

}  // namespace touchdown::training
