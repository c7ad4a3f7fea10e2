#include "tests/support/photographed_pad.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "models/angles.h"
#include "models/random_stream.h"
#include "tests/support/photo_artwork.h"
#include "tests/support/photo_camera.h"
#include "tests/support/photo_floors.h"
#include "tests/support/photo_light.h"
#include "tests/support/photo_paper.h"
#include "tests/support/photo_sensor.h"
#include "tests/support/photo_surfaces.h"

namespace touchdown::tests {
namespace {

using models::kPi;
using models::RandomStream;

/// Draws conditions. A fraction of the photographs is hard in each respect, and few in more than three.
void DrawConditions(RandomStream& random, PhotoConditions& conditions) {
  const auto one_of = [&](const std::vector<std::string>& names) {
    return names[static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(names.size()) - 1))];
  };
  conditions.obliquity_deg = random.Bernoulli(0.3) ? random.Uniform(40.0, 60.0) : random.Uniform(0.0, 40.0);
  conditions.glare = random.Bernoulli(0.25) ? random.Uniform(0.1, 0.9) : 0.0;
  conditions.shadow = random.Bernoulli(0.3) ? random.Uniform(0.25, 0.8) : 1.0;
  conditions.exposure = random.Bernoulli(0.15)   ? random.Uniform(0.12, 0.3)
                        : random.Bernoulli(0.15) ? random.Uniform(1.0, 1.5)
                                                 : random.Uniform(0.4, 0.9);
  conditions.noise_sigma = random.Bernoulli(0.2) ? random.Uniform(4.0, 10.0) : random.Uniform(0.5, 4.0);
  conditions.jpeg_quality = random.Bernoulli(0.6) ? random.UniformInt(35, 95) : 100;
  conditions.floor = one_of(FloorKinds());
  if (random.Bernoulli(0.3)) conditions.marks = one_of(MarkingKinds());
}

/// Draws a view with the whole ring in the image. The narrowest stroke has a minimum width in px, so that it is
/// visible.
void DrawViewOfRing(const PhotoPaper& paper, RandomStream& random, Photograph& photo) {
  const models::CameraModel& camera = photo.camera;
  const double stroke_fraction =
      std::min(photo.pad.h_stroke_m, photo.pad.ring_width_m) / (2.0 * photo.pad.outer_radius_m);
  const double obliquity = models::DegToRad(photo.conditions.obliquity_deg);
  const double min_fraction =
      std::max(0.06, 1.6 / (stroke_fraction * std::cos(obliquity) * std::min(camera.height_px, camera.width_px)));
  const double max_fraction = 0.8 * std::min(1.0, 1.05 * camera.width_px / camera.height_px);
  const double size_fraction =
      std::exp(random.Uniform(std::log(std::min(min_fraction, 0.5 * max_fraction)), std::log(max_fraction)));
  const PhotoView view = DrawView(camera, paper, photo.pad.outer_radius_m, size_fraction, obliquity, random);
  photo.X_WC = view.X_WC;
  photo.ring_box = view.ring_box;
  photo.center_px = camera.Project(photo.X_WC.inverse() * Eigen::Vector3d::Zero()).value();
  photo.conditions.size_fraction = photo.ring_box.height / camera.height_px;
}

Artwork Print(const Photograph& photo, RandomStream& random) {
  const double px_per_m = photo.ring_box.width / (2.0 * photo.pad.outer_radius_m);
  Artwork art(photo.pad,
              (photo.camera.width_px <= 800 ? 2.0 : 1.2) * std::max(px_per_m, 60.0 / photo.pad.outer_radius_m));
  if (photo.subject == "pad") {
    PrintPad(photo.pad, art);
    if (photo.conditions.marks != "none") PrintMarkings(photo.pad, photo.conditions.marks, random, art);
  } else {
    PrintDistractor(photo.pad, photo.subject, random, art);
  }
  return art;
}

cv::Mat1f Illuminate(const Photograph& photo, const Artwork& art, const PhotoPaper& paper, RandomStream& random) {
  const models::CameraModel& camera = photo.camera;
  const int samples = camera.width_px * camera.height_px <= 500000 ? 2 : 1;
  const cv::Rect2d ring_box(photo.ring_box.tl() * samples, photo.ring_box.size() * static_cast<double>(samples));
  const PhotoSurfaces surfaces = VisibleSurfaces(photo, art, paper, samples, random);
  const cv::Mat1f light = DrawLight(surfaces.reflectance.size(), ring_box, photo.conditions.shadow, random);
  cv::Mat1f radiance = surfaces.reflectance.mul(light).mul(surfaces.lambert);
  AddGlare(photo.conditions.glare, ring_box, surfaces.toner, random, radiance);
  if (samples > 1) cv::resize(radiance, radiance, {camera.width_px, camera.height_px}, 0, 0, cv::INTER_AREA);
  return radiance;
}

/// Draws blur of up to a fraction of the narrowest stroke, with which a person can still read the H.
void Blur(Photograph& photo, RandomStream& random, cv::Mat1f& radiance) {
  const double px_per_m = std::min(photo.ring_box.width, photo.ring_box.height) / (2.0 * photo.pad.outer_radius_m);
  const double narrowest_px = px_per_m * std::min(photo.pad.h_stroke_m, photo.pad.ring_width_m);
  const double max_blur_px = std::max(0.6, 0.9 * narrowest_px);
  const double scale = std::max(photo.camera.width_px, photo.camera.height_px) / 640.0;
  double defocus = random.Uniform(0.3, 0.7) * scale, motion = 0.0;
  if (random.Bernoulli(0.25)) defocus = random.Uniform(0.7, 4.0) * scale;
  if (random.Bernoulli(0.2)) motion = random.Uniform(1.0, 8.0) * scale;
  defocus = std::min(defocus, 0.5 * max_blur_px);
  motion = std::min(motion, max_blur_px);
  Defocus(radiance, defocus);
  SmearAlong(radiance, motion, random.Uniform(-kPi, kPi));
  photo.conditions.blur_px = std::hypot(2.0 * defocus, motion);
  photo.conditions.blur_fraction = photo.conditions.blur_px / narrowest_px;
}

Photograph TakePhotograph(const std::string& subject, RandomStream& random) {
  Photograph photo;
  photo.subject = subject;
  photo.pad = DrawAnyPad(random);
  photo.camera = DrawCamera(random);
  PhotoConditions& conditions = photo.conditions;
  DrawConditions(random, conditions);
  if (subject != "pad") conditions.marks = "none";
  if (subject.starts_with("floor ")) conditions.floor = subject.substr(6);
  const PhotoPaper paper(photo.pad.outer_radius_m, random.Bernoulli(0.3) ? random.Uniform(0.05, 0.25) : 0.0, random);
  conditions.curl = paper.LargestHeight();
  DrawViewOfRing(paper, random, photo);
  const Artwork art = Print(photo, random);
  cv::Mat1f radiance = Illuminate(photo, art, paper, random);
  Blur(photo, random, radiance);
  const cv::Mat1b developed =
      Develop(std::move(radiance), conditions.exposure, conditions.noise_sigma, conditions.jpeg_quality, random);
  photo.image = models::Image(photo.camera.width_px, photo.camera.height_px);
  developed.copyTo(cv::Mat1b(photo.camera.height_px, photo.camera.width_px, photo.image.pixels.data()));
  return photo;
}

}  // namespace

Photograph PhotographPad(std::uint64_t seed) {
  RandomStream random(seed, "photographs.pad");
  return TakePhotograph("pad", random);
}

Photograph PhotographDistractor(std::uint64_t seed) {
  RandomStream random(seed, "photographs.look_alike");  // The name determines the figures of docs/footage.md.
  return TakePhotograph(DistractorKinds()[seed % DistractorKinds().size()], random);
}

}  // namespace touchdown::tests
