#include "sim/sensors/imager.h"

namespace touchdown::sim {

Imager::Imager(const mjModel_& model, const models::CameraModel& camera, double noise_sigma, std::uint64_t seed)
    : optics_(camera), renderer_(model, optics_.pinhole_view()), noise_(noise_sigma, seed) {}

models::Image Imager::Expose(mjData_& data, ExposurePath X_WC) {
  const models::Image& pinhole = renderer_.Render(data, PoseAlong(X_WC, 0.5));
  return noise_.Apply(optics_.Expose(pinhole, X_WC));
}

}  // namespace touchdown::sim
