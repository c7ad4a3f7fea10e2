#include "scenarios/experiments/recognition.h"

#include <array>
#include <cmath>
#include <optional>

#include "estimator/paper/binarize.h"
#include "estimator/paper/classifier.h"
#include "estimator/paper/components.h"
#include "estimator/paper/reason.h"
#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/recognition_images.h"
#include "scenarios/experiments/static_scene.h"
#include "scenarios/runner/metrics.h"
#include "scenarios/runner/pad_view.h"
#include "scenarios/training/classifier_truth.h"
#include "scenarios/training/classifier_views.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

using estimator::paper::ComponentClass;
using models::RandomStream;

constexpr std::array<double, 6> kRecallDistances_m = {0.12, 0.3, 0.6, 1.0, 1.6, 2.5};
constexpr std::array<double, 5> kRecallTilts_deg = {0.0, 10.0, 20.0, 35.0, 50.0};

/// Views as in flights and hand-held motions, and more difficult ones: strong perspective, blur, low contrast.
training::ViewConfig Views() {
  return {.min_distance_m = kRecallDistances_m.front(),
          .max_distance_m = kRecallDistances_m.back(),
          .max_tilt_deg = kRecallTilts_deg.back()};
}

/// A random room with distractors, with or without a pad. Draws labeled views of it, and runs the estimator on them.
class RecognitionRoom {
 public:
  RecognitionRoom(const runner::Scenario& nominal, int number, bool with_pad)
      : nominal_(nominal),
        random_(static_cast<std::uint64_t>(number), with_pad ? "paper.recognition.pad" : "paper.recognition.decoys"),
        scene_(sim::MakeScene(DistractorConfig(with_pad), nominal.pad, random_.Bits())),
        shapes_(training::FindGroundShapes(scene_)),
        static_scene_(nominal, scene_, random_.Bits(), views_.noise_sigmas),
        unverified_(WithoutTemplateCheck(nominal)) {}

  /// A frame, its labels and its estimate.
  struct Sample {
    training::View view = {};
    models::Image image = {};
    std::vector<std::optional<ComponentClass>> truth = {};  ///< True class of each component; nullopt if unclear.
    estimator::FrameResult estimate = {};
    estimator::FrameResult unverified = {};  ///< Estimate of the same frame with `verify: none`.
  };

  /// Draws a view. In a room with a pad, four views in five aim at the pad, and all others at distractors.
  Sample DrawSample() {
    const bool aims_at_pad = scene_.config.pad && random_.Bernoulli(0.8);
    const int first = scene_.config.pad ? 2 : 0, last = static_cast<int>(shapes_.size()) - 1;
    const training::GroundShape& target =
        shapes_[static_cast<std::size_t>(aims_at_pad ? 0 : random_.UniformInt(first, last))];
    Sample sample{.view = training::DrawView(views_, scene_, target, nominal_.camera.model, random_)};
    sample.image = static_scene_.Capture(sample.view);
    const estimator::paper::ComponentSet set =
        estimator::paper::ExtractComponents(estimator::paper::Binarize(sample.image.View()).View());
    std::vector<std::optional<training::ProjectedShape>> projections;
    for (const training::GroundShape& each : shapes_)
      projections.push_back(training::Project(each, nominal_.camera.model, sample.view.X_WC));
    const double blur_px = training::MotionBlur(sample.view, target, nominal_.camera.model) + sample.view.defocus_px;
    sample.truth =
        training::LabelComponents(set, shapes_, projections, {sample.image.width, sample.image.height}, blur_px, {});
    const Eigen::Isometry3d X_WB = sample.view.X_WC * nominal_.vehicle.X_BC().inverse();
    sample.estimate = static_scene_.Estimate(sample.image, DownInBody(X_WB));
    sample.unverified = unverified_.Estimate(sample.image, DownInBody(X_WB));
    return sample;
  }

  bool ShowsWholeRing(const training::View& view) const {
    return scene_.config.pad && runner::WholeRingInView(nominal_.camera.model, nominal_.pad, view.X_WC);
  }
  /// Whether an estimate of a frame from `view` has a pad that is not there.
  bool IsFalsePad(const estimator::FrameResult& estimate, const training::View& view) const {
    if (!estimate.pad_px) return false;
    const auto pad_px = nominal_.camera.model.Project(view.X_WC.inverse() * Eigen::Vector3d::Zero());
    return !scene_.config.pad || !pad_px || (*pad_px - *estimate.pad_px).norm() > runner::kFalsePad_px;
  }

 private:
  static sim::SceneConfig DistractorConfig(bool with_pad) {
    sim::SceneConfig config;
    config.lone_circles = 12;
    config.lone_letters = 12;
    config.pad = with_pad;
    return config;
  }

  static runner::Scenario WithoutTemplateCheck(runner::Scenario scenario) {
    scenario.estimator.paper.verify = estimator::paper::Verify::kNone;
    return scenario;
  }

  const runner::Scenario& nominal_;
  training::ViewConfig views_ = Views();
  RandomStream random_;
  sim::Scene scene_;
  std::vector<training::GroundShape> shapes_;
  StaticScene static_scene_;
  SingleFrameEstimator unverified_;
};

/// Class that the strategy `paper` assigned to a component, from the name of its box. The overlay has one box for each
/// component, in the same order.
ComponentClass ClassOf(const estimator::Overlay::Box& box) {
  for (const ComponentClass label : {ComponentClass::kCircle, ComponentClass::kH}) {
    if (box.name == Name(label)) return label;
  }
  return ComponentClass::kOther;
}

/// Counts false positives, by component and by frame, in a room without a pad.
Json CountFalsePositives(const runner::Scenario& nominal, int number, int frames,
                         const util::StopRequested& stop_requested) {
  RecognitionRoom room(nominal, number, false);
  // Confusion matrix: number of components by true class and assigned class.
  std::array<std::array<int, 3>, 3> confusion{};
  int frames_false_circle = 0, frames_false_letter = 0, pairs = 0, pads = 0, unverified_pads = 0;
  for (int i = 0; i < frames; ++i) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
    const RecognitionRoom::Sample sample = room.DrawSample();
    bool false_circle = false, false_letter = false;
    for (std::size_t k = 0; k < sample.truth.size(); ++k) {
      if (!sample.truth[k]) continue;
      const auto truth = *sample.truth[k], label = ClassOf(sample.estimate.overlay.boxes.at(k));
      ++confusion[static_cast<std::size_t>(truth)][static_cast<std::size_t>(label)];
      false_circle |= label == ComponentClass::kCircle && truth != label;
      false_letter |= label == ComponentClass::kH && truth != label;
    }
    frames_false_circle += false_circle ? 1 : 0;
    frames_false_letter += false_letter ? 1 : 0;
    const bool is_pair = sample.estimate.reason == Name(estimator::paper::Reason::kNoEllipse) || sample.estimate.pose;
    pairs += is_pair ? 1 : 0;
    pads += sample.estimate.pose ? 1 : 0;
    unverified_pads += sample.unverified.pose ? 1 : 0;
  }
  return {{"frames", frames},
          {"given", confusion},
          {"frames_false_circle", frames_false_circle},
          {"frames_false_letter", frames_false_letter},
          {"pairs", pairs},
          {"pads", pads},
          {"unverified_pads", unverified_pads}};
}

std::size_t BinOf(double value, std::span<const double> edges) {
  std::size_t bin = 0;
  while (bin + 2 < edges.size() && value >= edges[bin + 1]) ++bin;
  return bin;
}

/// Counts the frames with the whole ring in view, and those in which the pad was found, by distance and tilt.
Json CountDetections(const runner::Scenario& nominal, int number, int frames,
                     const util::StopRequested& stop_requested) {
  RecognitionRoom room(nominal, number, true);
  std::array<std::array<std::array<int, 2>, kRecallTilts_deg.size() - 1>, kRecallDistances_m.size() - 1> bins{};
  int in_view = 0, found = 0, false_pads = 0, all = 0, unverified_found = 0, unverified_false_pads = 0;
  while (in_view < frames) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
    const RecognitionRoom::Sample sample = room.DrawSample();
    ++all;
    const bool is_false = room.IsFalsePad(sample.estimate, sample.view),
               unverified_is_false = room.IsFalsePad(sample.unverified, sample.view);
    false_pads += is_false ? 1 : 0;
    unverified_false_pads += unverified_is_false ? 1 : 0;
    if (!room.ShowsWholeRing(sample.view)) continue;
    const bool correct = sample.estimate.pose && !is_false;
    const double distance_m = sample.view.X_WC.translation().norm();
    const double tilt_deg = models::RadToDeg(std::acos(std::clamp(-sample.view.X_WC.linear()(2, 2), -1.0, 1.0)));
    auto& bin = bins[BinOf(distance_m, kRecallDistances_m)][BinOf(tilt_deg, kRecallTilts_deg)];
    ++bin[0];
    bin[1] += correct ? 1 : 0;
    ++in_view;
    found += correct ? 1 : 0;
    unverified_found += sample.unverified.pose && !unverified_is_false ? 1 : 0;
  }
  return {{"all", all},
          {"frames", in_view},
          {"found", found},
          {"false_pads", false_pads},
          {"unverified_found", unverified_found},
          {"unverified_false_pads", unverified_false_pads},
          {"bins", bins}};
}

std::string FalseId(int room) { return fmt::format("recognition_decoys_{}", room); }
std::string FoundId(int room) { return fmt::format("recognition_pad_{}", room); }
constexpr const char* kImagesId = "recognition_pictures";

std::string Percent(const util::Interval& rate, int digits) {
  return fmt::format("{} % (95 %: {} to {})", util::Fixed(100.0 * rate.value, digits),
                     util::Fixed(100.0 * rate.low, digits), util::Fixed(100.0 * rate.high, digits));
}

/// Sums of the counts of all rooms without a pad.
struct FalseCounts {
  std::array<std::array<int, 3>, 3> confusion{};
  int frames = 0, frames_false_circle = 0, frames_false_letter = 0, pairs = 0, pads = 0, unverified_pads = 0;

  /// False positive rate of a class, p1 for circles and p2 for H: components of the other classes that are labeled as
  /// `label`, divided by all components of the other classes.
  util::Interval FalseRate(ComponentClass label) const {
    const auto as = static_cast<std::size_t>(label);
    int wrong = 0, others = 0;
    for (std::size_t truth = 0; truth < confusion.size(); ++truth) {
      if (truth == as) continue;
      for (std::size_t k = 0; k < 3; ++k) others += confusion[truth][k];
      wrong += confusion[truth][as];
    }
    return util::WilsonInterval(wrong, std::max(1, others));
  }
};

FalseCounts SumFalse(const PaperPlan& plan, const Measured& measured) {
  FalseCounts sum;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    const Json& json = measured.at(FalseId(room));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum.confusion[i][k] += json.at("given")[i][k].get<int>();
    }
    sum.frames += json.at("frames").get<int>();
    sum.frames_false_circle += json.at("frames_false_circle").get<int>();
    sum.frames_false_letter += json.at("frames_false_letter").get<int>();
    sum.pairs += json.at("pairs").get<int>();
    sum.pads += json.at("pads").get<int>();
    sum.unverified_pads += json.at("unverified_pads").get<int>();
  }
  return sum;
}

void ReportFalse(const FalseCounts& sum, PaperSection& section) {
  const util::Interval p1 = sum.FalseRate(ComponentClass::kCircle), p2 = sum.FalseRate(ComponentClass::kH);
  const util::Interval frames_p1 = util::WilsonInterval(sum.frames_false_circle, sum.frames),
                       frames_p2 = util::WilsonInterval(sum.frames_false_letter, sum.frames),
                       pairs = util::WilsonInterval(sum.pairs, sum.frames),
                       pads = util::WilsonInterval(sum.pads, sum.frames),
                       unverified = util::WilsonInterval(sum.unverified_pads, sum.frames);
  section.tables.push_back(
      {.name = "recognition_false_positives",
       .caption = fmt::format(
           "False positives in {} frames without a pad, with single rings and letters as distractors.", sum.frames),
       .head = {"what", "of the components", "of the frames"},
       .rows = {{"circle, p1", Percent(p1, 3), Percent(frames_p1, 2)},
                {"letter H, p2", Percent(p2, 3), Percent(frames_p2, 2)},
                {"pair that meets the geometric constraint", "-", Percent(pairs, 3)},
                {"landing pad, verify: none (as published)", "-", Percent(unverified, 3)},
                {"landing pad, verify: template", "-", Percent(pads, 3)}}});
  section.compared.push_back(
      {.quantity = "False pads, fraction of frames with decoys alone",
       .unit = "%",
       .published = 100.0 * std::min(frames_p1.value, frames_p2.value),
       .ours = 100.0 * pads.value,
       .spread = fmt::format("of {} frames; 95 %: up to {} %", sum.frames, util::Fixed(100.0 * pads.high, 3)),
       .why = "The published value is the bound of the paper, min(p1, p2) over the same frames."});
}

void ReportFound(const PaperPlan& plan, const Measured& measured, PaperSection& section) {
  std::array<std::array<std::array<int, 2>, kRecallTilts_deg.size() - 1>, kRecallDistances_m.size() - 1> bins{};
  int frames = 0, found = 0, false_pads = 0, all = 0, unverified_found = 0, unverified_false_pads = 0;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    const Json& json = measured.at(FoundId(room));
    frames += json.at("frames").get<int>();
    found += json.at("found").get<int>();
    false_pads += json.at("false_pads").get<int>();
    unverified_found += json.at("unverified_found").get<int>();
    unverified_false_pads += json.at("unverified_false_pads").get<int>();
    all += json.at("all").get<int>();
    for (std::size_t i = 0; i < bins.size(); ++i) {
      for (std::size_t k = 0; k < bins[i].size(); ++k) {
        for (std::size_t j = 0; j < 2; ++j) bins[i][k][j] += json.at("bins")[i][k][j].get<int>();
      }
    }
  }
  report::ReportTable table{
      .name = "recognition_recall",
      .caption = fmt::format("Detections in {} frames with the whole ring in view: {}. Of all {} frames in "
                             "these rooms, {} had a false pad.",
                             frames, Percent(util::WilsonInterval(found, frames), 1), all, false_pads),
      .head = {"distance, m"}};
  for (std::size_t k = 0; k + 1 < kRecallTilts_deg.size(); ++k) {
    table.head.push_back(fmt::format("tilt {:.0f} to {:.0f}°", kRecallTilts_deg[k], kRecallTilts_deg[k + 1]));
  }
  for (std::size_t i = 0; i < bins.size(); ++i) {
    std::vector<std::string> cells{fmt::format("{} to {}", kRecallDistances_m[i], kRecallDistances_m[i + 1])};
    for (const auto& [count, correct] : bins[i]) {
      cells.push_back(count == 0 ? "none" : fmt::format("{} % of {}", util::Fixed(100.0 * correct / count, 0), count));
    }
    table.rows.push_back(std::move(cells));
  }
  section.tables.push_back(std::move(table));
  section.tables.push_back(
      {.name = "recognition_verification",
       .caption = "Detection with and without the template check (estimator.paper.verify), on the same frames.",
       .head = {"verify", fmt::format("found, of {} frames with the whole ring", frames),
                fmt::format("false pads, of {} frames", all)},
       .rows = {{"template", Percent(util::WilsonInterval(found, frames), 1), std::to_string(false_pads)},
                {"none (as published)", Percent(util::WilsonInterval(unverified_found, frames), 1),
                 std::to_string(unverified_false_pads)}}});
}

PaperSection ReportRecognition(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "recognition", .title = "Landing pad recognition (Secs. IV-A, VI-A, Figs. 2, 4, 5)"}};
  section.paragraphs.push_back(fmt::format(
      "{} rooms with random floor, light, posters, objects, a dozen single rings and a dozen single letters. The "
      "views have distances from {} to {} m and tilts up to {:.0f}°. A third of them is as in a steady hover; the "
      "others have motion blur, defocus, low contrast and noise of up to 7 of 255.",
      plan.recognition_scenes, kRecallDistances_m.front(), kRecallDistances_m.back(), kRecallTilts_deg.back()));
  ReportFalse(SumFalse(plan, measured), section);
  ReportFound(plan, measured, section);
  section.images = ImagesFromJson(measured.at(kImagesId));
  return section;
}

}  // namespace

Experiment RecognitionExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  runner::Scenario nominal;
  vehicle.ApplyTo(nominal);
  const int frames = plan.recognition_frames;
  const double expected_s = 3.0 + 0.02 * frames;
  Experiment experiment;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    experiment.measurements.push_back({.id = FalseId(room),
                                       .expected_s = expected_s,
                                       .measure = [nominal, room, frames](const util::StopRequested& stop_requested) {
                                         return CountFalsePositives(nominal, room, frames, stop_requested);
                                       }});
    experiment.measurements.push_back({.id = FoundId(room),
                                       .expected_s = expected_s,
                                       .measure = [nominal, room, frames](const util::StopRequested& stop_requested) {
                                         return CountDetections(nominal, room, frames, stop_requested);
                                       }});
  }
  experiment.measurements.push_back(
      {.id = kImagesId, .expected_s = 8.0, .measure = [nominal](const util::StopRequested&) {
         return MakeRecognitionImages(nominal);
       }});
  experiment.report = [plan](const Measured& measured) { return ReportRecognition(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
