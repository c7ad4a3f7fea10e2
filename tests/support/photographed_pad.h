#pragma once

#include <cstdint>

#include "tests/support/photograph.h"

namespace touchdown::tests {

/// Synthetic photograph of a pad. It shares no code, texture or light model with sim/ and the training of the
/// classifier. photo_artwork prints the sheet, photo_paper bends it, photo_floors draws the floor, photo_camera selects
/// the view, photo_surfaces finds the surface at each pixel, photo_light illuminates it, and photo_sensor computes the
/// image. The same seed gives the same photograph, on the same type of CPU.
Photograph PhotographPad(std::uint64_t seed);

/// Synthetic photograph of a distractor. `seed` modulo the number of DistractorKinds() selects the kind.
Photograph PhotographDistractor(std::uint64_t seed);

}  // namespace touchdown::tests
