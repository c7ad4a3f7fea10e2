#pragma once

#include <cstdint>

#include "tests/support/photograph.h"

namespace touchdown::tests {

/// A photograph of a pad. It shares no code, texture or model of light with sim/ and the training of the classifier:
/// photo_artwork prints the sheet, photo_paper bends it, photo_floors lay what it lies on, photo_camera aims,
/// photo_surfaces finds the surface that each pixel sees, photo_light lights it and photo_sensor makes the image.
/// The same seed gives the same photograph, on the same type of CPU.
Photograph PhotographPad(std::uint64_t seed);

/// The same of what is not the pad. The i-th kind of DistractorKinds(), modulo their number, is `seed`'s.
Photograph PhotographDistractor(std::uint64_t seed);

}  // namespace touchdown::tests
