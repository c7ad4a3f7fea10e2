#include "scenarios/runner/events/cover_pad.h"

#include "models/error.h"
#include "scenarios/runner/scenario.h"

namespace touchdown::runner {

void CoverPad::Check(const Scenario& scenario, double duration_s) const {
  if (!scenario.scene.pad) throw InputError("there is no pad to cover: scene.pad is false");
  RequireCameraFrame(scenario, duration_s);
}

}  // namespace touchdown::runner
