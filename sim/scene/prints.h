#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "models/landing_pad.h"
#include "sim/scene/scene.h"

/// Artwork of the items of the room, as reflectance: 0 is a perfect black, 255 a perfect white. Column 0 lies at the
/// sheet's -X edge, row 0 at its +Y edge.
namespace touchdown::sim {

inline constexpr double kPaper = 225.0;
inline constexpr double kInk = 25.0;

/// The landing pad's sheet, each texel the mean of 25 samples of PadOutline::IsBlack where an edge crosses it.
cv::Mat1b PrintPad(const models::LandingPad& pad, int width, int height);

/// A ring, a letter H, a rectangle or a poster, drawn from the item's texture_seed for its aspect. Throws
/// std::logic_error for a solid item.
cv::Mat1b PrintSheet(const SceneItem& item, int width, int height);

/// Six faces of a solid item, one below the other.
cv::Mat1b PaintSolid(const SceneItem& item, int face_width);

}  // namespace touchdown::sim
