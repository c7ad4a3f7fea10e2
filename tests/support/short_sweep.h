#pragma once

#include <string>

#include "tests/support/temporary_folder.h"

namespace touchdown::tests {

/// Writes sweep.yaml, whose flights take about a second each. `more` is appended to the file.
inline void WriteShortSweep(const TemporaryFolder& folder, int seeds, const std::string& more = "") {
  folder.Put("short.yaml", R"(start: {airborne: true, position_m: [0, 0, 0.4]}
script: [{do: hover, position_m: [0, 0, 0.4], duration_s: 0.1}]
camera: {model: {width_px: 320, height_px: 240, fx_px: 160, fy_px: 160, cx_px: 159.5, cy_px: 119.5}}
scene: {floor_size_m: 4, posters: 0, objects: 0}
)");
  folder.Put("sweep.yaml", "base: short.yaml\nseeds: {count: " + std::to_string(seeds) + "}\n" + more);
}

}  // namespace touchdown::tests
