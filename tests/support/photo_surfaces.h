#pragma once

#include <opencv2/core.hpp>

#include "models/random_stream.h"
#include "tests/support/photo_artwork.h"
#include "tests/support/photo_paper.h"
#include "tests/support/photograph.h"

namespace touchdown::tests {

/// Surfaces that the pixels of an image view. The image has `samples` times the resolution of the camera.
struct PhotoSurfaces {
  cv::Mat1f reflectance;  ///< 0 to 1.
  cv::Mat1f toner;        ///< Fraction of the pixel that is glossy toner.
  cv::Mat1f lambert;      ///< Irradiance of the paper, relative to that of a flat sheet.
};

/// Computes the surfaces in view. Uses pad, subject, camera, X_WC and floor of `photo`.
PhotoSurfaces VisibleSurfaces(const Photograph& photo, const Artwork& art, const PhotoPaper& paper, int samples,
                              models::RandomStream& random);

}  // namespace touchdown::tests
