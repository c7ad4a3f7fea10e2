#include "scenarios/report/flight_folder.h"

#include "scenarios/flight/output_folder.h"
#include "scenarios/report/contact_sheet.h"

namespace touchdown::scenarios {

FlightResult FlyIntoFolder(const Scenario& scenario, const std::filesystem::path& place, const FrameObserver& on_frame,
                           const StopRequested& stop_requested) {
  OutputFolder folder(
      place, {.files = {"result.json", "scenario.yaml", "flight.csv", "frames.csv", "tracking.csv", "truth.tum",
                        "estimate.tum", "tracking.tum", "frame_timing.csv", "timing.json", "frames.png"},
              .mark = "\"log_sha256\""});
  ContactSheet sheet(scenario.camera.model, scenario.time);
  const auto look = [&](const auto& frame, const auto& estimate, const auto& record) {
    sheet.Add(frame, estimate, record);
    if (on_frame) on_frame(frame, estimate, record);
  };
  const FlightResult result = Fly(scenario, look, stop_requested);
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
  folder.Commit();
  return result;
}

}  // namespace touchdown::scenarios
