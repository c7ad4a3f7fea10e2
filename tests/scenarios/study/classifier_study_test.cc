#include "scenarios/study/classifier_study.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace touchdown::scenarios {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr double kLeastRecall = 0.99;
constexpr double kLeastAgreement = 0.995;

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

/// The comment that says how a network was made.
std::string Head(const std::string& code) { return code.substr(0, code.find("*/")); }

void ExpectAllClassesWellRecognised(const ConfusionMatrix& matrix) {
  for (int label = 0; label < kClasses; ++label) {
    EXPECT_GT(matrix.Total(label), 1000);
    EXPECT_GE(matrix.Recall(label), kLeastRecall) << "class " << label;
  }
}

/// `touchdown train` as the docs have it, against what is committed.
TEST(ClassifierStudy, RemakesTheNetworkThatIsCompiledIn) {
  const ClassifierStudy study = StudyClassifier({}, kSeed);
  ExpectAllClassesWellRecognised(study.test);

  ConfusionMatrix compiled_in;
  int agreeing = 0;
  for (const LabelledPattern& each : study.test_patterns) {
    const estimator::FrameTrace::Label label = estimator::Classify(each.pattern).label;
    ++compiled_in.count[static_cast<std::size_t>(each.label)][static_cast<std::size_t>(label)];
    agreeing += label == LabelOf(study.network, each.pattern) ? 1 : 0;
  }
  ExpectAllClassesWellRecognised(compiled_in);
  EXPECT_GE(agreeing, kLeastAgreement * static_cast<double>(study.test_patterns.size()));

  const std::string remade = ContentOf("classifier_weights.c", ClassifierFiles(study));
  const std::string committed = Read("estimator/paper/classifier_weights.c");
  ASSERT_FALSE(remade.empty());
  // Elsewhere than where it was made, the last bits of rendering and training may be others.
  if (Head(remade) != Head(committed)) GTEST_SKIP() << "the committed network was made on another type of machine";
  EXPECT_EQ(remade, committed);
  EXPECT_NE(Read("docs/classifier.md").find(ToText(study.test)), std::string::npos)
      << "docs/classifier.md has another confusion matrix than\n"
      << ToText(study.test);
}

}  // namespace
}  // namespace touchdown::scenarios
