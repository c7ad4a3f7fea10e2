#include "scenarios/cli/flight_folder.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/datasets/flight_bag.h"
#include "scenarios/datasets/flight_recording.h"
#include "scenarios/report/contact_sheet.h"
#include "scenarios/report/flight_files.h"
#include "scenarios/report/flight_page.h"
#include "scenarios/report/flight_video.h"
#include "scenarios/runner/flight_tables.h"
#include "scenarios/util/output_folder.h"

namespace touchdown::cli {
namespace {

constexpr const char* kRecordingFolder = "recording";

/// Files of a flight directory.
std::vector<std::string> FileNames() {
  std::vector<std::string> names{"result.json", "scenario.yaml", "timing.json", "frames.png",
                                 "flight.mp4",  "flight.bag",    "report.html"};
  for (auto& [name, text] : runner::WriteTables({})) names.push_back(std::move(name));
  return names;
}

}  // namespace

runner::FlightResult FlyIntoFolder(const runner::Scenario& scenario, const std::filesystem::path& place,
                                   const FlightExtras& extras, runner::FlightObservers observers,
                                   const util::StopRequested& stop_requested) {
  util::OutputFolder folder(place, {.files = FileNames(),
                                    .signature = report::kFlightSignature,
                                    .subfolders = {{kRecordingFolder, datasets::IsFlightRecordingFile}}});
  report::ContactSheet sheet(scenario.assumed_camera(), scenario.time);
  std::vector<runner::FlightObserver*> all(observers.begin(), observers.end());
  all.push_back(&sheet);
  std::optional<report::FlightVideo> video;
  if (extras.video) all.push_back(&video.emplace(scenario, folder.PathOf("flight.mp4")));
  std::optional<datasets::FlightRecording> recording;
  if (extras.recording) all.push_back(&recording.emplace(scenario, folder.PathOf(kRecordingFolder)));
  std::optional<datasets::FlightBag> bag;
  if (extras.bag) all.push_back(&bag.emplace(scenario, folder.PathOf("flight.bag")));
  const runner::FlightLog log = runner::FlyClosedLoop(scenario, all, stop_requested);
  const runner::FlightResult result = runner::JudgeFlight(scenario, log);
  if (video) video->Finish();
  if (recording) recording->Finish(log);
  if (bag) bag->Finish(log);
  folder.Write("scenario.yaml", runner::ScenarioYaml(scenario));
  for (const auto& [name, text] : runner::WriteTables(log)) folder.Write(name, text);
  folder.Write("timing.json", runner::TimingJson(result.timing));
  if (const auto png = sheet.Png()) folder.Write("frames.png", *png);
  folder.Write("result.json", runner::ResultJson(scenario, result));
  folder.Write("report.html", report::FlightPage(report::ReadFlightFiles(folder.PathOf(""))));
  folder.Commit();
  return result;
}

}  // namespace touchdown::cli
