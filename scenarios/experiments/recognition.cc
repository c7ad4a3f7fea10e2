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
#include "scenarios/experiments/recognition_pictures.h"
#include "scenarios/experiments/still_room.h"
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

/// Views as flights and hands have them, and worse: large perspective, blur, weak contrast.
training::ViewConfig Views() {
  return {.nearest_m = kRecallDistances_m.front(),
          .farthest_m = kRecallDistances_m.back(),
          .largest_tilt_deg = kRecallTilts_deg.back()};
}

/// A frame of a room and all that is known of it.
class Room {
 public:
  Room(const runner::Scenario& nominal, int number, bool with_pad)
      : nominal_(nominal),
        random_(static_cast<std::uint64_t>(number), with_pad ? "paper.recognition.pad" : "paper.recognition.decoys"),
        scene_(sim::MakeScene(Decoys(with_pad), nominal.pad, random_.Bits())),
        shapes_(training::ShapesOf(scene_)),
        room_(nominal, scene_, random_.Bits(), views_.noise_sigmas) {}

  struct Seen {
    training::View view = {};
    models::Image image = {};
    std::vector<std::optional<ComponentClass>> truth = {};  ///< Of each component, where clear.
    estimator::FrameResult estimate = {};
  };

  /// With a pad, four views in five look for it; all others look for decoys.
  Seen Look() {
    const bool for_pad = scene_.config.pad && random_.Chance(0.8);
    const int first = scene_.config.pad ? 2 : 0, last = static_cast<int>(shapes_.size()) - 1;
    const training::GroundShape& target =
        shapes_[static_cast<std::size_t>(for_pad ? 0 : random_.UniformInt(first, last))];
    Seen seen{.view = training::DrawView(views_, scene_, target, nominal_.camera.model, random_)};
    seen.image = room_.Take(seen.view);
    const estimator::paper::ComponentSet set =
        estimator::paper::ExtractComponents(estimator::paper::Binarize(seen.image.View()).View());
    std::vector<std::optional<training::ProjectedShape>> projections;
    for (const training::GroundShape& each : shapes_)
      projections.push_back(training::Project(each, nominal_.camera.model, seen.view.X_WC));
    const double blur_px = training::MotionBlur(seen.view, target, nominal_.camera.model) + seen.view.defocus_px;
    seen.truth =
        training::LabelComponents(set, shapes_, projections, {seen.image.width, seen.image.height}, blur_px, {});
    const Eigen::Isometry3d X_WB = seen.view.X_WC * nominal_.vehicle.X_BC().inverse();
    seen.estimate = room_.Estimate(seen.image, DownIn(X_WB));
    return seen;
  }

  bool ShowsWholeRing(const training::View& view) const {
    return scene_.config.pad && runner::WholeRingInView(nominal_.camera.model, nominal_.pad, view.X_WC);
  }
  bool IsFalse(const Seen& seen) const {
    if (!seen.estimate.pad_px) return false;
    const auto pad_px = nominal_.camera.model.Project(seen.view.X_WC.inverse() * Eigen::Vector3d::Zero());
    return !scene_.config.pad || !pad_px || (*pad_px - *seen.estimate.pad_px).norm() > runner::kFalsePad_px;
  }

 private:
  static sim::SceneConfig Decoys(bool with_pad) {
    sim::SceneConfig config;
    config.lone_circles = 12;
    config.lone_letters = 12;
    config.pad = with_pad;
    return config;
  }

  const runner::Scenario& nominal_;
  training::ViewConfig views_ = Views();
  RandomStream random_;
  sim::Scene scene_;
  std::vector<training::GroundShape> shapes_;
  StillRoom room_;
};

/// The class that `paper` gave to a component, by the name of its box: there is one box for each component, in order.
ComponentClass ClassOf(const estimator::Overlay::Box& box) {
  for (const ComponentClass label : {ComponentClass::kCircle, ComponentClass::kH}) {
    if (box.name == Name(label)) return label;
  }
  return ComponentClass::kOther;
}

/// Of a room's frames without a pad: components and frames that were taken for what they are not.
Json CountFalse(const runner::Scenario& nominal, int number, int frames, const util::StopRequested& stop_requested) {
  Room room(nominal, number, false);
  // By the true class: how many there are, and how many of them are labeled circle and H.
  std::array<std::array<int, 3>, 3> given{};
  int frames_false_circle = 0, frames_false_letter = 0, pairs = 0, pads = 0;
  for (int i = 0; i < frames; ++i) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
    const Room::Seen seen = room.Look();
    bool false_circle = false, false_letter = false;
    for (std::size_t k = 0; k < seen.truth.size(); ++k) {
      if (!seen.truth[k]) continue;
      const auto truth = *seen.truth[k], label = ClassOf(seen.estimate.overlay.boxes.at(k));
      ++given[static_cast<std::size_t>(truth)][static_cast<std::size_t>(label)];
      false_circle |= label == ComponentClass::kCircle && truth != label;
      false_letter |= label == ComponentClass::kH && truth != label;
    }
    frames_false_circle += false_circle ? 1 : 0;
    frames_false_letter += false_letter ? 1 : 0;
    const bool is_pair = seen.estimate.reason == Name(estimator::paper::Reason::kNoEllipse) || seen.estimate.pose;
    pairs += is_pair ? 1 : 0;
    pads += seen.estimate.pose ? 1 : 0;
  }
  return {{"frames", frames},
          {"given", given},
          {"frames_false_circle", frames_false_circle},
          {"frames_false_letter", frames_false_letter},
          {"pairs", pairs},
          {"pads", pads}};
}

std::size_t BinOf(double value, std::span<const double> edges) {
  std::size_t bin = 0;
  while (bin + 2 < edges.size() && value >= edges[bin + 1]) ++bin;
  return bin;
}

/// Of a room's frames with a pad in view: how many found it, by distance and tilt.
Json CountFound(const runner::Scenario& nominal, int number, int frames, const util::StopRequested& stop_requested) {
  Room room(nominal, number, true);
  std::array<std::array<std::array<int, 2>, kRecallTilts_deg.size() - 1>, kRecallDistances_m.size() - 1> bins{};
  int whole = 0, found = 0, false_pads = 0, all = 0;
  while (whole < frames) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
    const Room::Seen seen = room.Look();
    ++all;
    false_pads += room.IsFalse(seen) ? 1 : 0;
    if (!room.ShowsWholeRing(seen.view)) continue;
    const bool right = seen.estimate.pose && !room.IsFalse(seen);
    const double distance_m = seen.view.X_WC.translation().norm();
    const double tilt_deg = models::RadToDeg(std::acos(std::clamp(-seen.view.X_WC.linear()(2, 2), -1.0, 1.0)));
    auto& bin = bins[BinOf(distance_m, kRecallDistances_m)][BinOf(tilt_deg, kRecallTilts_deg)];
    ++bin[0];
    bin[1] += right ? 1 : 0;
    ++whole;
    found += right ? 1 : 0;
  }
  return {{"all", all}, {"frames", whole}, {"found", found}, {"false_pads", false_pads}, {"bins", bins}};
}

std::string FalseId(int room) { return fmt::format("recognition_decoys_{}", room); }
std::string FoundId(int room) { return fmt::format("recognition_pad_{}", room); }
constexpr const char* kPicturesId = "recognition_pictures";

std::string Percent(const util::Interval& share, int digits) {
  return fmt::format("{} % (95 %: {} to {})", util::Fixed(100.0 * share.value, digits),
                     util::Fixed(100.0 * share.low, digits), util::Fixed(100.0 * share.high, digits));
}

/// Sums of what the rooms without a pad counted.
struct FalseCounts {
  std::array<std::array<int, 3>, 3> given{};
  int frames = 0, frames_false_circle = 0, frames_false_letter = 0, pairs = 0, pads = 0;

  /// Of the components that are no circles (H), the share labeled so: p1 and p2.
  util::Interval FalseShare(ComponentClass label) const {
    const auto as = static_cast<std::size_t>(label);
    int wrong = 0, others = 0;
    for (std::size_t truth = 0; truth < given.size(); ++truth) {
      if (truth == as) continue;
      for (std::size_t k = 0; k < 3; ++k) others += given[truth][k];
      wrong += given[truth][as];
    }
    return util::WilsonInterval(wrong, std::max(1, others));
  }
};

FalseCounts SumFalse(const PaperPlan& plan, const Measured& measured) {
  FalseCounts sum;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    const Json& json = measured.at(FalseId(room));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum.given[i][k] += json.at("given")[i][k].get<int>();
    }
    sum.frames += json.at("frames").get<int>();
    sum.frames_false_circle += json.at("frames_false_circle").get<int>();
    sum.frames_false_letter += json.at("frames_false_letter").get<int>();
    sum.pairs += json.at("pairs").get<int>();
    sum.pads += json.at("pads").get<int>();
  }
  return sum;
}

void ReportFalse(const FalseCounts& sum, PaperSection& section) {
  const util::Interval p1 = sum.FalseShare(ComponentClass::kCircle), p2 = sum.FalseShare(ComponentClass::kH);
  const util::Interval frames_p1 = util::WilsonInterval(sum.frames_false_circle, sum.frames),
                       frames_p2 = util::WilsonInterval(sum.frames_false_letter, sum.frames),
                       pairs = util::WilsonInterval(sum.pairs, sum.frames),
                       pads = util::WilsonInterval(sum.pads, sum.frames);
  section.tables.push_back(
      {.name = "recognition_false_positives",
       .caption = fmt::format("False positives over {} frames without a pad, with lone rings and letters.", sum.frames),
       .head = {"what", "of the components", "of the frames"},
       .rows = {{"circle, p1", Percent(p1, 3), Percent(frames_p1, 2)},
                {"letter H, p2", Percent(p2, 3), Percent(frames_p2, 2)},
                {"pair that meets the geometric constraint", "-", Percent(pairs, 3)},
                {"landing pad", "-", Percent(pads, 3)}}});
  section.compared.push_back(
      {.quantity = "False pads, share of frames with decoys alone",
       .unit = "%",
       .published = 100.0 * std::min(frames_p1.value, frames_p2.value),
       .ours = 100.0 * pads.value,
       .spread = fmt::format("of {} frames; 95 %: up to {} %", sum.frames, util::Fixed(100.0 * pads.high, 3)),
       .why = "The bound is the paper's: below min(p1, p2) of the same frames."});
}

void ReportFound(const PaperPlan& plan, const Measured& measured, PaperSection& section) {
  std::array<std::array<std::array<int, 2>, kRecallTilts_deg.size() - 1>, kRecallDistances_m.size() - 1> bins{};
  int frames = 0, found = 0, false_pads = 0, all = 0;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    const Json& json = measured.at(FoundId(room));
    frames += json.at("frames").get<int>();
    found += json.at("found").get<int>();
    false_pads += json.at("false_pads").get<int>();
    all += json.at("all").get<int>();
    for (std::size_t i = 0; i < bins.size(); ++i) {
      for (std::size_t k = 0; k < bins[i].size(); ++k) {
        for (std::size_t j = 0; j < 2; ++j) bins[i][k][j] += json.at("bins")[i][k][j].get<int>();
      }
    }
  }
  report::ReportTable table{
      .name = "recognition_recall",
      .caption = fmt::format("Found, of {} frames that show the ring whole: {}. Of {} frames in these "
                             "rooms {} showed a pad where there was none.",
                             frames, Percent(util::WilsonInterval(found, frames), 1), all, false_pads),
      .head = {"distance, m"}};
  for (std::size_t k = 0; k + 1 < kRecallTilts_deg.size(); ++k) {
    table.head.push_back(fmt::format("tilt {:.0f} to {:.0f}°", kRecallTilts_deg[k], kRecallTilts_deg[k + 1]));
  }
  for (std::size_t i = 0; i < bins.size(); ++i) {
    std::vector<std::string> cells{fmt::format("{} to {}", kRecallDistances_m[i], kRecallDistances_m[i + 1])};
    for (const auto& [count, right] : bins[i]) {
      cells.push_back(count == 0 ? "none" : fmt::format("{} % of {}", util::Fixed(100.0 * right / count, 0), count));
    }
    table.rows.push_back(std::move(cells));
  }
  section.tables.push_back(std::move(table));
}

PaperSection ReportRecognition(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "recognition", .title = "Landing pad recognition (Secs. IV-A, VI-A, Figs. 2, 4, 5)"}};
  section.paragraphs.push_back(fmt::format(
      "{} rooms with a floor, light, posters, objects and a dozen lone rings and lone letters of their "
      "own, seen from {} to {} m, up to {:.0f}° tilted, a third of the views as in a calm hover, others in "
      "motion, out of focus, in weak contrast and with noise of up to 7 of 255.",
      plan.recognition_scenes, kRecallDistances_m.front(), kRecallDistances_m.back(), kRecallTilts_deg.back()));
  ReportFalse(SumFalse(plan, measured), section);
  ReportFound(plan, measured, section);
  section.pictures = PicturesFromJson(measured.at(kPicturesId));
  return section;
}

}  // namespace

Experiment RecognitionExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  runner::Scenario nominal;
  vehicle.Equip(nominal);
  const int frames = plan.recognition_frames;
  const double expected_s = 3.0 + 0.02 * frames;
  Experiment experiment;
  for (int room = 1; room <= plan.recognition_scenes; ++room) {
    experiment.measurements.push_back({.id = FalseId(room),
                                       .expected_s = expected_s,
                                       .take = [nominal, room, frames](const util::StopRequested& stop_requested) {
                                         return CountFalse(nominal, room, frames, stop_requested);
                                       }});
    experiment.measurements.push_back({.id = FoundId(room),
                                       .expected_s = expected_s,
                                       .take = [nominal, room, frames](const util::StopRequested& stop_requested) {
                                         return CountFound(nominal, room, frames, stop_requested);
                                       }});
  }
  experiment.measurements.push_back(
      {.id = kPicturesId, .expected_s = 8.0, .take = [nominal](const util::StopRequested&) {
         return TakeRecognitionPictures(nominal);
       }});
  experiment.report = [plan](const Measured& measured) { return ReportRecognition(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
