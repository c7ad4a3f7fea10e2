#pragma once

#include "models/landing_pad.h"
#include "sim/scene/scene.h"

namespace touchdown::tests {

/// Configuration of a room that contains only the pad.
inline sim::SceneConfig EmptyRoomConfig() { return {.posters = 0, .lone_circles = 0, .lone_letters = 0, .objects = 0}; }

/// Scene of a room that contains only the nominal pad.
inline sim::Scene EmptyRoom() { return sim::MakeScene(EmptyRoomConfig(), models::LandingPad{}, 1); }

}  // namespace touchdown::tests
