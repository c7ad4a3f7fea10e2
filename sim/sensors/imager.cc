#include "sim/sensors/imager.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace touchdown::sim {
namespace {

constexpr int kWidestView_px = 8192;

int LargestFactor(const PinholeView& view, int oversampling) {
  return std::clamp(kWidestView_px / std::max(view.width_px, view.height_px), 1, oversampling);
}

/// The same view with `factor` x `factor` pixels per pixel.
PinholeView Finer(const PinholeView& view, int factor) {
  const auto scaled = [factor](double center_px) { return factor * center_px + 0.5 * (factor - 1); };
  return {.width_px = factor * view.width_px,
          .height_px = factor * view.height_px,
          .focal_px = factor * view.focal_px,
          .cx_px = scaled(view.cx_px),
          .cy_px = scaled(view.cy_px)};
}

}  // namespace

Imager::Imager(const mjModel_& model, CameraOptics optics, const std::vector<double>& noise_sigmas, std::uint64_t seed,
               int oversampling)
    : optics_(std::move(optics)),
      renderer_(model, Finer(optics_.pinhole_view(), LargestFactor(optics_.pinhole_view(), oversampling))) {
  const PinholeView& view = optics_.pinhole_view();
  if (LargestFactor(view, oversampling) > 1) averaged_ = models::Image(view.width_px, view.height_px);
  for (const double sigma : noise_sigmas) noises_.emplace_back(sigma, seed);
}

const FineImage& Imager::Expose(mjData_& data, ExposurePath X_WC) {
  const models::Image& rendered = renderer_.Render(data, PoseAlong(X_WC, 0.5));
  if (averaged_.pixels.empty()) return optics_.Expose(rendered, X_WC);
  const cv::Mat1b from(rendered.height, rendered.width, const_cast<std::uint8_t*>(rendered.pixels.data()));
  cv::Mat1b to(averaged_.height, averaged_.width, averaged_.pixels.data());
  cv::resize(from, to, to.size(), 0.0, 0.0, cv::INTER_AREA);
  return optics_.Expose(averaged_, X_WC);
}

models::Image Imager::AddNoise(const FineImage& exposed, std::size_t noise_level) {
  return noises_.at(noise_level).Apply(exposed);
}

}  // namespace touchdown::sim
