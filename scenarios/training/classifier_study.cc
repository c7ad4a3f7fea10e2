#include "scenarios/training/classifier_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "models/error.h"
#include "models/random_stream.h"
#include "scenarios/training/classifier_variation.h"

namespace touchdown::training {
namespace {

using estimator::paper::ComponentClass;
using models::RandomStream;
using Patterns = std::vector<LabeledPattern>;

constexpr int kAnnotatedFrames = 12;

std::uint64_t SceneSeed(std::uint64_t seed, const std::string& part, int scene) {
  return RandomStream(seed, fmt::format("classifier.{}.{}", part, scene)).Bits();
}

/// Duration of an epoch, in units of the duration of a scene.
constexpr double kScenesPerEpoch = 0.2;

/// Reports the progress of a study.
class ProgressCounter {
 public:
  ProgressCounter(const ClassifierStudyConfig& config, const StudyProgress& progress)
      : total_(config.training_scenes + config.validation_scenes + config.test_scenes +
               kScenesPerEpoch * config.training.max_epochs),
        progress_(progress) {}

  void Add(double scenes, const std::string& text) {
    done_ += scenes;
    if (progress_) progress_(text, std::min(1.0, done_ / total_));
  }

 private:
  double total_;
  double done_ = 0.0;
  const StudyProgress& progress_;
};

/// Samples of several scenes.
struct Pool {
  Patterns patterns;
  std::vector<cv::Mat3b> annotated_frames;
  int unclear = 0;
};

/// Collects the samples of all scenes of a part. Keeps one annotated frame of each of the first scenes.
Pool Collect(const ClassifierStudyConfig& config, std::uint64_t seed, const std::string& part, int scenes,
             ProgressCounter& counter) {
  const sim::CameraOptics optics(config.scene.camera);
  Pool pool;
  for (int scene = 0; scene < scenes; ++scene) {
    const int annotated_count = scene < kAnnotatedFrames ? 1 : 0;
    SceneSamples samples = CollectSceneSamples(config.scene, optics, SceneSeed(seed, part, scene), annotated_count);
    std::move(samples.patterns.begin(), samples.patterns.end(), std::back_inserter(pool.patterns));
    std::move(samples.annotated_frames.begin(), samples.annotated_frames.end(),
              std::back_inserter(pool.annotated_frames));
    pool.unclear += samples.unclear;
    counter.Add(1.0, fmt::format("{} scene {} of {}, {} components", part, scene + 1, scenes, pool.patterns.size()));
  }
  return pool;
}

Patterns FilterByClass(const Patterns& patterns, ComponentClass label) {
  Patterns result;
  std::copy_if(patterns.begin(), patterns.end(), std::back_inserter(result),
               [&](const LabeledPattern& each) { return each.label == label; });
  return result;
}

/// Random subset of at most `count` patterns.
Patterns RandomSubset(Patterns patterns, int count, RandomStream& random) {
  const std::size_t size = std::min(patterns.size(), static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < size; ++i) {
    const int last = static_cast<int>(patterns.size() - 1);
    std::swap(patterns[i], patterns[static_cast<std::size_t>(random.UniformInt(static_cast<int>(i), last))]);
  }
  patterns.resize(size);
  return patterns;
}

void Append(Patterns& to, const Patterns& more) { to.insert(to.end(), more.begin(), more.end()); }

std::vector<TrainingSample> SamplesOf(const Patterns& patterns) {
  std::vector<TrainingSample> samples;
  for (const LabeledPattern& each : patterns) {
    samples.push_back({{each.pattern.begin(), each.pattern.end()}, static_cast<int>(each.label)});
  }
  return samples;
}

/// Sorts clutter by increasing posterior of the class "other".
void SortHardestFirst(Patterns& clutter, const Perceptron& network) {
  constexpr auto kOther = static_cast<std::size_t>(ComponentClass::kOther);
  std::vector<double> posterior;
  for (const LabeledPattern& each : clutter) posterior.push_back(network.Posteriors(each.pattern)[kOther]);
  std::vector<std::size_t> order(clutter.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return posterior[a] < posterior[b]; });
  Patterns sorted;
  for (const std::size_t i : order) sorted.push_back(clutter[i]);
  clutter = std::move(sorted);
}

/// Selects the training set: random circles and letters, the hardest clutter of a first network, and random clutter.
Patterns ChooseTrainingSet(const ClassifierStudyConfig& config, const Patterns& pool, const Patterns& validation,
                           std::uint64_t seed) {
  RandomStream random(seed, "classifier.choice");
  Patterns shapes = RandomSubset(FilterByClass(pool, ComponentClass::kCircle), config.circles, random);
  Append(shapes, RandomSubset(FilterByClass(pool, ComponentClass::kH), config.letters, random));
  Patterns clutter = FilterByClass(pool, ComponentClass::kOther);

  Patterns first = shapes;
  Append(first, RandomSubset(clutter, config.clutter, random));
  TrainingConfig first_config = config.training;
  first_config.max_epochs = config.first_network_epochs;
  const TrainingResult result =
      Train(SamplesOf(first), SamplesOf(validation), first_config, seed, {.vary = VaryPattern, .progress = {}});

  SortHardestFirst(clutter, result.network);
  const auto hardest = std::min(clutter.size(), static_cast<std::size_t>(config.hard_clutter * config.clutter));
  Append(shapes, {clutter.begin(), clutter.begin() + static_cast<std::ptrdiff_t>(hardest)});
  clutter.erase(clutter.begin(), clutter.begin() + static_cast<std::ptrdiff_t>(hardest));
  Append(shapes, RandomSubset(std::move(clutter), config.clutter - static_cast<int>(hardest), random));
  return shapes;
}

}  // namespace

ClassifierStudyConfig ClassifierStudyConfig::For(models::PadLetter letter) {
  ClassifierStudyConfig config;
  config.scene.letter = letter;
  if (letter == models::PadLetter::kRectangle) {
    config.training_scenes = 12;
    config.validation_scenes = 3;
    config.test_scenes = 8;
    config.training.max_epochs = config.training.patience_epochs = 40;
  }
  return config;
}

void ClassifierStudyConfig::Validate() const {
  scene.Validate();
  training.Validate();
  if (std::min({training_scenes, validation_scenes, test_scenes, circles, letters, clutter, first_network_epochs}) <
      1) {
    throw InputError("classifier study: numbers of scenes, samples and epochs must be at least 1");
  }
  if (!(hard_clutter >= 0.0 && hard_clutter <= 1.0)) throw InputError("classifier study: hard_clutter must be 0 to 1");
}

ClassifierStudy StudyClassifier(const ClassifierStudyConfig& config, std::uint64_t seed,
                                const StudyProgress& progress) {
  config.Validate();
  ProgressCounter counter(config, progress);
  const Pool pool = Collect(config, seed, "training", config.training_scenes, counter);
  const Pool validation = Collect(config, seed, "validation", config.validation_scenes, counter);
  const Patterns set = ChooseTrainingSet(config, pool.patterns, validation.patterns, seed);
  const auto report = [&](const EpochReport& epoch) {
    counter.Add(kScenesPerEpoch,
                fmt::format("epoch {} of {}, training loss {:.4f}, validation loss {:.4f}", epoch.epoch,
                            config.training.max_epochs, epoch.training_loss, epoch.validation_loss));
  };
  const TrainingResult result = Train(SamplesOf(set), SamplesOf(validation.patterns), config.training, seed,
                                      {.vary = VaryPattern, .progress = report});

  Pool test = Collect(config, seed, "test", config.test_scenes, counter);
  ClassifierStudy study{.letter = config.scene.letter,
                        .seed = seed,
                        .network = result.network,
                        .training = ComputeConfusion(result.network, set),
                        .test = ComputeConfusion(result.network, test.patterns),
                        .test_patterns = std::move(test.patterns),
                        .misclassified = {},
                        .annotated_frames = std::move(test.annotated_frames),
                        .unclear = test.unclear};
  std::copy_if(study.test_patterns.begin(), study.test_patterns.end(), std::back_inserter(study.misclassified),
               [&](const LabeledPattern& each) { return PredictLabel(study.network, each.pattern) != each.label; });
  return study;
}

}  // namespace touchdown::training
