#include "scenarios/training/classifier_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace touchdown::training {
namespace {

using models::PadLetter;
using testing::IsSupersetOf;

constexpr std::uint64_t kSeed = 1;
constexpr double kMinAgreement = 0.995;

std::string Read(const std::string& path) {
  std::ifstream file(TOUCHDOWN_SOURCE_DIR "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string ContentOf(const std::string& name, const std::vector<StudyFile>& files) {
  for (const StudyFile& file : files) {
    if (file.name == name) return file.content;
  }
  return {};
}

/// First comment of the code: the provenance of the network.
std::string Head(const std::string& code) { return code.substr(0, code.find("*/")); }

void ExpectAllClassesWellRecognized(const ConfusionMatrix& matrix, int min_count, double min_recall) {
  for (int label = 0; label < kClasses; ++label) {
    EXPECT_GT(matrix.Total(label), min_count);
    EXPECT_GE(matrix.Recall(label), min_recall) << "class " << label;
  }
}

/// Repeats the training of docs/classifier.md and compares its result with the committed files.
void ExpectReproduced(PadLetter letter, const std::string& weights, int min_count, double min_recall) {
  const ClassifierStudy study = StudyClassifier(ClassifierStudyConfig::For(letter), kSeed);
  ExpectAllClassesWellRecognized(study.test, min_count, min_recall);

  ConfusionMatrix compiled_in;
  int agreeing = 0;
  for (const LabeledPattern& each : study.test_patterns) {
    const estimator::paper::ComponentClass label = estimator::paper::Classify(each.pattern, letter).label;
    ++compiled_in.count[static_cast<std::size_t>(each.label)][static_cast<std::size_t>(label)];
    agreeing += label == PredictLabel(study.network, each.pattern) ? 1 : 0;
  }
  ExpectAllClassesWellRecognized(compiled_in, min_count, min_recall);
  EXPECT_GE(agreeing, kMinAgreement * static_cast<double>(study.test_patterns.size()));

  const std::string reproduced = ContentOf(weights, ClassifierFiles(study));
  const std::string committed = Read("estimator/paper/" + weights);
  ASSERT_FALSE(reproduced.empty());
  // On another type of CPU, the last bits of rendering and training may differ.
  if (Head(reproduced) != Head(committed))
    GTEST_SKIP() << "the committed network was trained on another type of machine";
  EXPECT_EQ(reproduced, committed);
  EXPECT_NE(Read("docs/classifier.md").find(ToText(study.test, letter)), std::string::npos)
      << "docs/classifier.md does not contain this confusion matrix:\n"
      << ToText(study.test, letter);
}

TEST(ClassifierStudy, ReproducesTheCompiledInNetwork) {
  ExpectReproduced(PadLetter::kH, "classifier_weights.c", 1000, 0.99);
}

TEST(ClassifierStudy, ReproducesTheCompiledInNetworkOfTheRectangle) {
  ExpectReproduced(PadLetter::kRectangle, "classifier_weights_rectangle.c", 400, 0.9);
}

TEST(ClassifierStudy, NamesItsFilesByTheLetter) {
  EXPECT_THAT(ClassifierFileNames(PadLetter::kH), IsSupersetOf({"confusion.json", "classifier_weights.c", "h.png"}));
  EXPECT_THAT(ClassifierFileNames(PadLetter::kRectangle),
              IsSupersetOf({"confusion.json", "classifier_weights_rectangle.c", "rectangle.png"}));
}

}  // namespace
}  // namespace touchdown::training
