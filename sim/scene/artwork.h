#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "models/landing_pad.h"
#include "sim/scene/scene.h"

/// Artwork of the pad and of the items of a scene, as reflectance: 0 is a perfect black, 255 a perfect white. Column 0
/// is at the sheet's -X edge, row 0 at its +Y edge.
namespace touchdown::sim {

inline constexpr double kPaper = 225.0;
inline constexpr double kInk = 25.0;

/// Artwork of the landing pad's sheet. A texel that an edge crosses is the mean of 25 samples of PadOutline::IsBlack.
cv::Mat1b PaintPad(const models::LandingPad& pad, int width, int height);

/// Artwork of a flat item: a ring, a letter H, a rectangle or a poster, drawn from the item's texture_seed and its
/// aspect ratio. Throws std::logic_error for a solid item.
cv::Mat1b PaintSheet(const SceneItem& item, int width, int height);

/// Surface of a solid item: its six faces, one below the other.
cv::Mat1b PaintSolid(const SceneItem& item, int face_width);

}  // namespace touchdown::sim
