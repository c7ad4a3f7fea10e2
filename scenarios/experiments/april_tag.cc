#include "scenarios/experiments/april_tag.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace touchdown::experiments {

struct AprilTagDetector::Impl {
  explicit Impl(float decimate) {
    apriltag_detector_add_family(detector, family);
    detector->quad_decimate = decimate;
    detector->nthreads = 1;
  }
  ~Impl() {
    apriltag_detector_destroy(detector);
    tag36h11_destroy(family);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();
};

AprilTagDetector::AprilTagDetector(float decimate) : impl_(std::make_unique<Impl>(decimate)) {}
AprilTagDetector::~AprilTagDetector() = default;

int AprilTagDetector::Detect(const models::ImageView& image) {
  image_u8_t view{image.width, image.height, static_cast<std::int32_t>(image.stride),
                  const_cast<std::uint8_t*>(image.data)};
  zarray_t* const detections = apriltag_detector_detect(impl_->detector, &view);
  const int count = zarray_size(detections);
  apriltag_detections_destroy(detections);
  return count;
}

}  // namespace touchdown::experiments
