#include "scenarios/cli/train.h"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>

#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/progress_line.h"
#include "scenarios/flight/interrupted.h"
#include "scenarios/flight/output_folder.h"
#include "scenarios/flight/stopwatch.h"
#include "scenarios/study/classifier_study.h"

namespace touchdown::scenarios {
namespace {

struct Options {
  std::string out;
  std::uint64_t seed = 1;
};

/// How much is done, and the time to go.
class TrainProgress {
 public:
  void Tell(const std::string& text, double share) {
    if (InterruptRequested()) throw Interrupted();
    if (!line_.IsDue()) return;
    const double left_s = since_start_.seconds() * (1.0 - share) / share;
    line_.Show(fmt::format("{:3.0f}%  {}, {:.0f} s to go", 100.0 * share, text, left_s));
  }

 private:
  ProgressLine line_;
  Stopwatch since_start_;
};

int TrainWith(const Options& options) {
  OutputFolder folder(options.out, {.files = {"confusion.json", "confusion.txt", "classifier_weights.c", "circle.png",
                                              "h.png", "other.png", "mistaken.png", "frames.png"},
                                    .mark = "\"touchdown.classifier\""});
  ClassifierStudy study = [&] {
    TrainProgress progress;
    return StudyClassifier({}, options.seed,
                           [&](const std::string& text, double share) { progress.Tell(text, share); });
  }();
  for (const StudyFile& file : ClassifierFiles(study)) folder.Write(file.name, file.content);
  folder.Commit();
  fmt::print("{}files in {}\n", ToText(study.test), options.out);
  return kPassed;
}

}  // namespace

void AddTrain(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("train", "Train the classifier on rendered scenes and write it as C code");
  command.add_option("--out", options->out, "Folder for the code, the confusion matrix and the pictures")->required();
  command.add_option("--seed", options->seed, "Seed of scenes, views and training")->capture_default_str();
  command.callback([options, &run] { run = [options] { return TrainWith(*options); }; });
}

}  // namespace touchdown::scenarios
