#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/cli/progress.h"
#include "scenarios/training/classifier_study.h"
#include "scenarios/util/interrupted.h"
#include "scenarios/util/output_folder.h"

namespace touchdown::cli {
namespace {

struct TrainOptions {
  std::string out;
  std::string letter = "h";
  std::uint64_t seed = 1;
  OutputOptions output;
};

int TrainWith(const TrainOptions& options) {
  const models::PadLetter letter =
      options.letter == "rectangle" ? models::PadLetter::kRectangle : models::PadLetter::kH;
  util::OutputFolder folder(options.out,
                            {.files = training::ClassifierFileNames(letter), .signature = "\"touchdown.classifier\""});
  training::ClassifierStudy study = [&] {
    Progress progress(!options.output.ForPeople());
    return training::StudyClassifier(training::ClassifierStudyConfig::For(letter), options.seed,
                                     [&](const std::string& text, double fraction) {
                                       if (InterruptRequested()) throw util::Interrupted();
                                       if (progress.IsDue()) progress.Update(fraction, text);
                                     });
  }();
  for (const training::StudyFile& file : training::ClassifierFiles(study)) folder.Write(file.name, file.content);
  folder.Commit();
  if (options.output.json) fmt::print("{}", training::ToJson(study.test, study.letter));
  if (options.output.ForPeople())
    fmt::print("{}files in {}\n", training::ToText(study.test, study.letter), options.out);
  return kPassed;
}

}  // namespace

void AddTrain(CLI::App& app, Run& run) {
  const auto options = std::make_shared<TrainOptions>();
  CLI::App& command = *app.add_subcommand("train", "Train the classifier on rendered scenes, and write it as C code");
  command.add_option("--out", options->out, "Output directory for the C code, the confusion matrix and the images")
      ->required();
  command.add_option("--letter", options->letter, "Letter inside the ring of the pad")
      ->check(CLI::IsMember({"h", "rectangle"}))
      ->capture_default_str();
  command.add_option("--seed", options->seed, "Seed of the scenes, the views and the training")->capture_default_str();
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return TrainWith(*options); }; });
}

}  // namespace touchdown::cli
