#include "scenarios/runner/events/lose_frames.h"

#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void LoseFrames::Check(const Scenario& scenario, double duration_s) const { RequireCameraFrame(scenario, duration_s); }

}  // namespace touchdown::runner
