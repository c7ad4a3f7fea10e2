#include "scenarios/experiments/reproduce_paper.h"

#include <fmt/format.h>

#include <string>

#include "models/error.h"
#include "scenarios/experiments/accuracy.h"
#include "scenarios/experiments/ambiguity.h"
#include "scenarios/experiments/calibrations.h"
#include "scenarios/experiments/computation_time.h"
#include "scenarios/experiments/conditions.h"
#include "scenarios/experiments/landings.h"
#include "scenarios/experiments/measurement_store.h"
#include "scenarios/experiments/outdoor.h"
#include "scenarios/experiments/pad_size.h"
#include "scenarios/experiments/paper_report.h"
#include "scenarios/experiments/recognition.h"
#include "scenarios/experiments/table_one.h"
#include "scenarios/experiments/yaw.h"
#include "scenarios/util/file.h"
#include "scenarios/util/output_folder.h"
#include "scenarios/util/program_digest.h"

namespace touchdown::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReportSignature = "touchdown.paper";

util::FolderKind PaperFolder() {
  return {.files = {"paper.json", "report.html", "README.md", "summary.csv", "table_1.tex"},
          .signature = kReportSignature,
          .subfolders = {{"figures", [](const fs::path& file) {
                            const std::string ending = file.extension().string();
                            return ending == ".csv" || ending == ".pdf" || ending == ".svg" || ending == ".jpg";
                          }}}};
}

std::string FolderJson(const ReproductionOptions& options) {
  return Json{{"kind", kReportSignature}, {"quick", options.quick}}.dump(2) + "\n";
}

/// Whether the earlier run in `out` was a quick one.
bool WasQuick(const fs::path& out) {
  const Json json = Json::parse(util::ReadTextFile(out / "paper.json"), nullptr, false);
  return json.is_object() && json.value("quick", false);
}

/// Creates the output directory, or checks that it comes from an earlier run of the same kind. An earlier report stays
/// until it is replaced. Throws InputError.
void PrepareFolder(const fs::path& out, const ReproductionOptions& options) {
  util::OutputFolder folder(out, PaperFolder());
  if (fs::exists(out / "paper.json")) {
    if (WasQuick(out) == options.quick) return;
    throw InputError(fmt::format("output folder {}: contains a {} run, which this run would replace; choose another",
                                 out.string(), options.quick ? "full" : "quick"));
  }
  folder.Write("paper.json", FolderJson(options));
  folder.Commit();
}

void WriteReport(const fs::path& out, const ReproductionOptions& options, const std::vector<PaperSection>& sections,
                 const std::string& table_one, const std::vector<std::pair<std::string, std::string>>& platform) {
  const ReportHead head{.signature = fmt::format("<!-- {} -->", kReportSignature),
                        .quick = options.quick,
                        .command = fmt::format("touchdown paper{} --out DIR", options.quick ? " --quick" : ""),
                        .platform = platform};
  const auto files = ReportFiles(head, sections);
  util::OutputFolder folder(out, PaperFolder());
  fs::create_directory(folder.PathOf("figures"));
  for (const auto& [name, content] : files) folder.Write(name, content);
  folder.Write("table_1.tex", table_one);
  folder.Write("paper.json", FolderJson(options));
  folder.Commit();
}

}  // namespace

std::vector<ComparedQuantity> ReproducePaper(const fs::path& out, const ReproductionOptions& options,
                                             const util::StopRequested& stop_requested,
                                             const MeasurementProgress& progress) {
  const PaperPlan plan = options.quick ? PaperPlan::Quick() : PaperPlan();
  PrepareFolder(out, options);
  const MeasurementStore store(out / "measurements", util::ProgramDigest() + (options.quick ? " quick" : ""));

  // All other experiments use the vehicle with the calibration measured here.
  const Experiment calibrations = CalibrationsExperiment(plan);
  constexpr double kCalibrationsFraction = 0.02;
  const auto first_progress = [&progress](double fraction, const std::string& text) {
    if (progress) progress(kCalibrationsFraction * fraction, text);
  };
  Measured measured = RunMeasurements(calibrations.measurements, store, options.jobs, stop_requested, first_progress);
  const PaperVehicle vehicle{.truth = TrueVehicle(), .calibration = CalibrationOf(measured)};

  const std::vector<Experiment> experiments{calibrations,
                                            RecognitionExperiment(plan, vehicle),
                                            YawExperiment(plan, vehicle),
                                            TableOneExperiment(plan, vehicle),
                                            LandingsExperiment(plan, vehicle),
                                            ComputationTimeExperiment(plan, vehicle),
                                            AccuracyExperiment(plan, vehicle),
                                            PadSizeExperiment(plan, vehicle),
                                            OutdoorExperiment(plan, vehicle),
                                            AmbiguityExperiment(plan, vehicle),
                                            ConditionsExperiment(plan, vehicle)};
  std::vector<Measurement> all;
  for (const Experiment& experiment : experiments) {
    all.insert(all.end(), experiment.measurements.begin(), experiment.measurements.end());
  }
  measured = RunMeasurements(all, store, options.jobs, stop_requested, progress);

  std::vector<PaperSection> sections;
  std::vector<ComparedQuantity> compared;
  for (const Experiment& experiment : experiments) {
    sections.push_back(experiment.report(measured));
    compared.insert(compared.end(), sections.back().compared.begin(), sections.back().compared.end());
  }
  WriteReport(out, options, sections, TableOneLatex(plan, measured), store.PlatformOf(kComputationTimeId));
  return compared;
}

}  // namespace touchdown::experiments
