#include "scenarios/report/flight_folder.h"

#include <optional>
#include <vector>

#include "scenarios/flight/output_folder.h"
#include "scenarios/footage/flight_bag.h"
#include "scenarios/footage/flight_recording.h"
#include "scenarios/report/contact_sheet.h"
#include "scenarios/report/flight_files.h"
#include "scenarios/report/flight_page.h"
#include "scenarios/report/flight_video.h"

namespace touchdown::scenarios {
namespace {

constexpr const char* kRecordingFolder = "recording";

}  // namespace

FlightResult FlyIntoFolder(const Scenario& scenario, const std::filesystem::path& place, const FlightExtras& extras,
                           FlightObservers observers, const StopRequested& stop_requested) {
  OutputFolder folder(place, {.files = {"result.json", "scenario.yaml", "flight.csv", "frames.csv", "tracking.csv",
                                        "truth.tum", "estimate.tum", "tracking.tum", "frame_timing.csv", "timing.json",
                                        "frames.png", "flight.mp4", "flight.bag", "report.html"},
                              .mark = kFlightMark,
                              .subfolders = {{kRecordingFolder, IsOfFlightRecording}}});
  ContactSheet sheet(scenario.assumed_camera(), scenario.time);
  std::vector<FlightObserver*> all(observers.begin(), observers.end());
  all.push_back(&sheet);
  std::optional<FlightVideo> video;
  if (extras.video) all.push_back(&video.emplace(scenario, folder.PathOf("flight.mp4")));
  std::optional<FlightRecording> recording;
  if (extras.recording) all.push_back(&recording.emplace(scenario, folder.PathOf(kRecordingFolder)));
  std::optional<FlightBag> bag;
  if (extras.bag) all.push_back(&bag.emplace(scenario, folder.PathOf("flight.bag")));
  const FlightResult result = Fly(scenario, all, stop_requested);
  if (video) video->Finish();
  if (recording) recording->Finish(result.truth);
  if (bag) bag->Finish(result);
  folder.Write("scenario.yaml", ScenarioYaml(scenario));
  folder.Write("flight.csv", result.tables.flight_csv);
  folder.Write("frames.csv", result.tables.frames_csv);
  folder.Write("tracking.csv", result.tables.tracking_csv);
  folder.Write("truth.tum", result.tables.truth_tum);
  folder.Write("estimate.tum", result.tables.estimate_tum);
  folder.Write("tracking.tum", result.tables.tracking_tum);
  folder.Write("frame_timing.csv", result.tables.frame_timing_csv);
  folder.Write("timing.json", TimingJson(result.timing));
  if (const auto png = sheet.Png()) folder.Write("frames.png", *png);
  folder.Write("result.json", ResultJson(scenario, result));
  folder.Write("report.html", FlightPage(ReadFlightFiles(folder.PathOf(""))));
  folder.Commit();
  return result;
}

}  // namespace touchdown::scenarios
