#pragma once

#include <opencv2/core.hpp>

#include "models/random_stream.h"
#include "tests/support/photo_artwork.h"
#include "tests/support/photo_paper.h"
#include "tests/support/photograph.h"

namespace touchdown::tests {

/// What each pixel of a picture looks at, the picture being `samples` times as fine as the camera's.
struct PhotoSurfaces {
  cv::Mat1f reflectance;  ///< Of 1.
  cv::Mat1f toner;        ///< Share of it that is glossy toner.
  cv::Mat1f lambert;      ///< How the paper leans to the light: over what it would get lying flat.
};

/// Needs of `photo` its pad, subject, camera, X_WC and floor.
PhotoSurfaces VisibleSurfaces(const Photograph& photo, const Artwork& art, const PhotoPaper& paper, int samples,
                              models::RandomStream& random);

}  // namespace touchdown::tests
