#include "scenarios/training/classifier_code.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>

#include "models/random_stream.h"

namespace touchdown::training {
namespace {

using models::PadLetter;

const std::vector<std::pair<std::string, std::string>> kProvenance{{"seed", "7"}, {"machine", "abacus"}};

Perceptron RandomClassifier(std::uint64_t seed) {
  Perceptron network = Perceptron::Random({}, seed);
  models::RandomStream random(seed, "code test");
  for (double& parameter : network.parameters()) parameter += 0.5 * random.Normal();
  return network.Rounded();
}

/// Numbers of the tables in the code, in the order of the file.
std::vector<float> Numbers(const std::string& code) {
  const std::string tables = code.substr(0, code.find("void "));
  const std::regex literal(R"([-+]?[0-9][0-9.]*(e[-+]?[0-9]+)?f\b)");
  std::vector<float> numbers;
  for (std::sregex_iterator i(tables.begin(), tables.end(), literal); i != std::sregex_iterator(); ++i) {
    numbers.push_back(std::strtof(i->str().c_str(), nullptr));
  }
  return numbers;
}

TEST(ClassifierCode, ContainsLiteralsThatReadBackExactly) {
  Perceptron network = RandomClassifier(1);
  network.parameters()[0] = 1.0;
  network.parameters()[1] = static_cast<float>(-1.25e-12);
  network.parameters()[2] = 0.0;
  network.parameters()[3] = static_cast<float>(3.0e9);
  const std::vector<float> numbers = Numbers(ClassifierCode(network, PadLetter::kH, kProvenance));
  ASSERT_EQ(numbers.size(), network.parameters().size());
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<float>(network.parameters()[i]));
}

TEST(ClassifierCode, WritesTheProvenanceInTheFirstComment) {
  const std::string code = ClassifierCode(RandomClassifier(2), PadLetter::kH, kProvenance);
  EXPECT_NE(code.substr(0, code.find("*/")).find("seed: 7\n *   machine: abacus\n"), std::string::npos);
}

TEST(ClassifierCode, NamesItsFunctionByTheLetter) {
  const Perceptron network = RandomClassifier(2);
  const std::string h = ClassifierCode(network, PadLetter::kH, {}),
                    rectangle = ClassifierCode(network, PadLetter::kRectangle, {});
  EXPECT_NE(h.find("void TouchdownClassifierPosteriors("), std::string::npos);
  const std::string name = "TouchdownRectangleClassifierPosteriors";
  ASSERT_NE(rectangle.find("void " + name + "("), std::string::npos);
  EXPECT_EQ(std::regex_replace(rectangle, std::regex(name), "TouchdownClassifierPosteriors"), h);
}

TEST(ClassifierCode, LimitsTheLineLength) {
  const std::string code = ClassifierCode(RandomClassifier(2), PadLetter::kH, kProvenance);
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120U) << line;
}

TEST(ClassifierCode, CompilesToTheSameNetwork) {
  const Perceptron network = RandomClassifier(3);
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "classifier_code_test";
  std::filesystem::create_directories(folder);
  const std::filesystem::path source = folder / "weights.c", library = folder / "weights.so";
  std::ofstream(source) << ClassifierCode(network, PadLetter::kH, kProvenance);
  const std::string command = "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror -shared -fPIC -I" TOUCHDOWN_SOURCE_DIR
                              " -o '" +
                              library.string() + "' '" + source.string() + "' -lm";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const std::unique_ptr<void, int (*)(void*)> handle(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL), dlclose);
  ASSERT_NE(handle, nullptr) << dlerror();
  const auto posteriors =
      reinterpret_cast<void (*)(const float*, float*)>(dlsym(handle.get(), "TouchdownClassifierPosteriors"));
  ASSERT_NE(posteriors, nullptr);

  models::RandomStream random(4, "code test");
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<float> pattern(196);
    for (float& cell : pattern) cell = random.Bernoulli(0.5) ? 0.0F : static_cast<float>(random.Uniform());
    std::array<float, 3> posterior{};
    posteriors(pattern.data(), posterior.data());
    const std::vector<double> expected = network.Posteriors(pattern);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(posterior[k], expected[k], 2e-5);
  }
}

TEST(ClassifierCode, RejectsANetworkOfAnotherShape) {
  EXPECT_THROW(ClassifierCode(Perceptron(Perceptron::Shape{10, 20, 3}), PadLetter::kH, {}), std::invalid_argument);
  EXPECT_THROW(ClassifierCode(Perceptron(Perceptron::Shape{196, 20, 4}), PadLetter::kH, {}), std::invalid_argument);
}

}  // namespace
}  // namespace touchdown::training
