#pragma once

#include "models/landing_pad.h"
#include "sim/scene/scene.h"

namespace touchdown::tests {

/// A room with nothing in it but the pad on its floor.
inline sim::SceneConfig EmptyRoomConfig() { return {.posters = 0, .lone_circles = 0, .lone_letters = 0, .objects = 0}; }

inline sim::Scene EmptyRoom() { return sim::MakeScene(EmptyRoomConfig(), models::LandingPad{}, 1); }

}  // namespace touchdown::tests
