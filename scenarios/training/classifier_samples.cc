#include "scenarios/training/classifier_samples.h"

#include <opencv2/imgproc.hpp>
#include <span>

#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "models/error.h"
#include "scenarios/training/classifier_camera.h"

namespace touchdown::training {
namespace {

using estimator::paper::Component;
using estimator::paper::ComponentClass;
using estimator::paper::ComponentSet;
using models::RandomStream;
using Labels = std::vector<std::optional<ComponentClass>>;

constexpr double kPadViewProbability = 0.4;

/// Replaces every third rectangle by an H.
void ReplaceEveryThirdRectangle(std::vector<sim::SceneItem>& items) {
  int rectangles = 0;
  for (sim::SceneItem& item : items) {
    if (item.kind == sim::SceneItem::Kind::kRectangle && ++rectangles % 3 == 0) {
      item.kind = sim::SceneItem::Kind::kLetterH;
    }
  }
}

sim::Scene DrawScene(const SceneSamplesConfig& config, RandomStream& random) {
  sim::SceneConfig scene;
  scene.lone_circles = config.lone_circles;
  scene.lone_letters = config.lone_letters;
  scene.illumination = random.Uniform(0.4, 1.1);
  sim::Scene drawn = sim::MakeScene(scene, DrawPad(config.letter, random), random.Bits());
  if (config.letter == models::PadLetter::kRectangle) ReplaceEveryThirdRectangle(drawn.items);
  return drawn;
}

cv::Scalar Color(const std::optional<ComponentClass>& label) {
  if (!label) return {0, 220, 255};
  if (*label == ComponentClass::kCircle) return {0, 200, 0};
  return *label == ComponentClass::kH ? cv::Scalar(255, 80, 0) : cv::Scalar(0, 0, 230);
}

cv::Mat3b AnnotatedImage(models::Image& image, const ComponentSet& set, const Labels& labels) {
  cv::Mat3b annotated;
  cv::cvtColor(cv::Mat1b(image.height, image.width, image.pixels.data()), annotated, cv::COLOR_GRAY2BGR);
  for (std::size_t i = 0; i < set.components.size(); ++i) {
    const Component& component = set.components[i];
    cv::rectangle(annotated, cv::Rect(component.u, component.v, component.width, component.height), Color(labels[i]));
  }
  return annotated;
}

/// Adds the patterns of all circles and letters of a frame, and of at most `max_clutter` clutter components.
void AddPatterns(const ComponentSet& set, const Labels& labels, int max_clutter, RandomStream& random,
                 SceneSamples& samples) {
  std::vector<std::size_t> clutter;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!labels[i]) {
      ++samples.unclear;
    } else if (*labels[i] == ComponentClass::kOther) {
      clutter.push_back(i);
    } else {
      samples.patterns.push_back({estimator::paper::PatternOf(set, set.components[i]), *labels[i]});
    }
  }
  for (int n = 0; n < max_clutter && !clutter.empty(); ++n) {
    const auto pick = static_cast<std::size_t>(random.UniformInt(0, static_cast<int>(clutter.size()) - 1));
    samples.patterns.push_back(
        {estimator::paper::PatternOf(set, set.components[clutter[pick]]), ComponentClass::kOther});
    clutter[pick] = clutter.back();
    clutter.pop_back();
  }
}

}  // namespace

void SceneSamplesConfig::Validate() const {
  camera.Validate();
  views.Validate();
  if (frames < 1 || lone_circles < 1 || lone_letters < 1 || clutter_per_frame < 1) {
    throw InputError("training set: frames, lone circles, lone letters and clutter per frame must be at least 1");
  }
}

models::LandingPad DrawPad(models::PadLetter letter, RandomStream& random) {
  const bool solid = letter == models::PadLetter::kRectangle;
  models::LandingPad pad;
  if (solid) pad.h_stroke_m = 0.5 * pad.h_width_m;
  if (random.Bernoulli(0.5)) return pad;
  pad.ring_width_m = pad.outer_radius_m * random.Uniform(0.07, 0.30);
  const double diagonal_m = 2.0 * pad.inner_radius_m() * random.Uniform(0.55, 0.88);
  const double slope = random.Uniform(0.45, 0.95);
  pad.h_height_m = diagonal_m / std::hypot(1.0, slope);
  pad.h_width_m = slope * pad.h_height_m;
  pad.h_stroke_m = pad.h_width_m * (solid ? 0.5 : random.Uniform(0.14, 0.34));
  return pad;
}

SceneSamples CollectSceneSamples(const SceneSamplesConfig& config, const sim::CameraOptics& optics, std::uint64_t seed,
                                 int annotated_count) {
  config.Validate();
  RandomStream random(seed, "classifier.scene");
  const sim::Scene scene = DrawScene(config, random);
  const std::vector<GroundShape> shapes = FindGroundShapes(scene);
  SceneCamera camera(scene, optics, config.views.noise_sigmas, random.Bits());
  SceneSamples samples;
  for (int frame = 0; frame < config.frames; ++frame) {
    const int last = static_cast<int>(shapes.size()) - 1;
    const int target = random.Bernoulli(kPadViewProbability) ? 0 : random.UniformInt(1, last);
    const GroundShape& shape = shapes[static_cast<std::size_t>(target)];
    const View view = DrawView(config.views, scene, shape, config.camera, random);
    models::Image image = camera.Capture(view);
    const models::Image dark = estimator::paper::Binarize(image.View());
    const ComponentSet set = estimator::paper::ExtractComponents(dark.View());
    std::vector<std::optional<ProjectedShape>> projections;
    for (const GroundShape& each : shapes) projections.push_back(Project(each, config.camera, view.X_WC));
    const double blur_px = MotionBlur(view, shape, config.camera) + view.defocus_px;
    const Labels labels = LabelComponents(set, shapes, projections, {image.width, image.height}, blur_px, config.truth);
    AddPatterns(set, labels, config.clutter_per_frame, random, samples);
    if (frame < annotated_count) samples.annotated_frames.push_back(AnnotatedImage(image, set, labels));
  }
  return samples;
}

}  // namespace touchdown::training
