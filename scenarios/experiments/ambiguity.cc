#include "scenarios/experiments/ambiguity.h"

#include <array>
#include <cmath>
#include <optional>

#include "estimator/pad/conic_pose.h"
#include "estimator/pad/ellipse_fit.h"
#include "estimator/pad/outlier_gate.h"
#include "estimator/paper/pad_pose.h"
#include "models/angles.h"
#include "models/random_stream.h"
#include "scenarios/experiments/static_scene.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/statistics.h"
#include "scenarios/util/text.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using models::RadToDeg;
using models::RandomStream;

constexpr std::array<double, 9> kAmbiguityTilts_deg = {0.0, 1.0, 2.0, 4.0, 6.0, 10.0, 15.0, 20.0, 30.0};
constexpr std::array<double, 7> kGravityErrors_deg = {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 15.0};
constexpr std::array<double, 3> kAmbiguityDistances_m = {0.5, 1.0, 1.5};
constexpr int kDirections = 12;  // Number of directions of the gravity error, for each magnitude.
// For a smaller angle between the hypotheses, the choice hardly matters.
constexpr double kSeparation_rad = DegToRad(2.0);

/// Draws a camera pose with the pad's center on the optical axis, at the given tilt in a random direction.
Eigen::Isometry3d DrawView(double tilt_rad, double distance_m, RandomStream& random) {
  const double yaw = random.Uniform(-1.2, 1.2), direction = random.Uniform(-models::kPi, models::kPi);
  const Eigen::Matrix3d R_WL = models::RotationFromTaitBryan({.roll = models::kPi, .yaw = yaw});
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() = models::RotationExp(tilt_rad * Vector3d(std::cos(direction), std::sin(direction), 0.0)) * R_WL;
  X_WC.translation() = -distance_m * X_WC.linear().col(2);
  return X_WC;
}

/// `v` rotated by `angle` about an axis perpendicular to it, which `direction` selects.
Vector3d Perturbed(const Vector3d& v, double angle, double direction) {
  const Vector3d a = v.unitOrthogonal(), b = v.cross(a);
  return models::RotationExp(angle * (std::cos(direction) * a + std::sin(direction) * b)) * v;
}

/// Results of the selection by Eq. 14 over many views and gravity errors.
struct SelectionCounts {
  int choices = 0;
  int wrong = 0;
  int wrong_far = 0;      ///< Wrong choices with separated hypotheses.
  int caught = 0;         ///< Wrong choices of wrong_far that the outlier gate rejects one frame after a correct pose.
  double wrong_mm = 0.0;  ///< Distance between wrong and correct position, summed over wrong_far.
};

/// Pose of the body for a pose hypothesis of the circle, with the true heading, so that only the branch differs.
Eigen::Isometry3d BodyAt(const estimator::pad::CirclePose& pose, const Eigen::Isometry3d& X_WC,
                         const Eigen::Isometry3d& X_BC) {
  const Vector3d up_W = -X_WC.linear().col(1);
  const double psi_C = std::atan2(up_W.y(), up_W.x());
  return estimator::paper::BodyPose(estimator::paper::CameraRotation(pose.n_C, psi_C), pose.p_CW, X_BC);
}

/// Whether the outlier gate rejects `wrong` one frame after it accepted `right`.
bool GateRejects(const Eigen::Isometry3d& right, const Eigen::Isometry3d& wrong, const models::TimeBase& time) {
  constexpr models::Tick kFrame = 20;
  estimator::pad::OutlierGate gate({}, time, estimator::FrameOrder::kSequence);
  gate.Accepts(0, right);
  return !gate.Accepts(kFrame, wrong);
}

using Counts = std::array<SelectionCounts, kGravityErrors_deg.size()>;

/// Selects between the hypotheses for every gravity error, and counts the results.
void CountSelections(const std::array<estimator::pad::CirclePose, 2>& poses, const Eigen::Isometry3d& X_WC,
                     const Eigen::Isometry3d& X_BC, RandomStream& random, Counts& counts) {
  const Vector3d z_C = X_WC.linear().transpose() * Vector3d::UnitZ();
  const std::size_t right = estimator::paper::ResolveByGravity(poses, z_C);
  const bool far = models::AngleBetween(poses[0].n_C, poses[1].n_C) > kSeparation_rad;
  const Eigen::Isometry3d right_X_WB = BodyAt(poses[right], X_WC, X_BC),
                          wrong_X_WB = BodyAt(poses[1 - right], X_WC, X_BC);
  const bool rejected = far && GateRejects(right_X_WB, wrong_X_WB, {});
  for (std::size_t i = 0; i < kGravityErrors_deg.size(); ++i) {
    for (int k = 0; k < kDirections; ++k) {
      const Vector3d reference =
          Perturbed(z_C, DegToRad(kGravityErrors_deg[i]), random.Uniform(0.0, 2.0 * models::kPi));
      SelectionCounts& count = counts[i];
      ++count.choices;
      if (estimator::paper::ResolveByGravity(poses, reference) == right) continue;
      ++count.wrong;
      if (!far) continue;
      ++count.wrong_far;
      count.caught += rejected ? 1 : 0;
      count.wrong_mm += 1e3 * (wrong_X_WB.translation() - right_X_WB.translation()).norm();
    }
  }
}

Json MeasureAmbiguity(const PaperVehicle& vehicle, double tilt_deg, int views,
                      const util::StopRequested& stop_requested) {
  const auto seed = static_cast<std::uint64_t>(100.0 + tilt_deg);
  runner::Scenario nominal;
  vehicle.ApplyTo(nominal);
  const Eigen::Isometry3d X_BC = nominal.assumed_vehicle().X_BC();
  StaticScene scene(nominal, sim::MakeScene({}, nominal.pad, seed), seed);
  RandomStream random(seed, "paper.ambiguity");
  Counts counts;
  int found = 0;
  for (int i = 0; i < views; ++i) {
    if (stop_requested && stop_requested()) throw util::Interrupted();
    const double distance_m = kAmbiguityDistances_m[static_cast<std::size_t>(i) % kAmbiguityDistances_m.size()];
    const Eigen::Isometry3d X_WC = DrawView(DegToRad(tilt_deg), distance_m, random);
    const models::Image image = scene.Capture({.X_WC = X_WC});
    const Vector3d gravity_B = X_BC.linear() * (-X_WC.linear().transpose() * Vector3d::UnitZ());
    const auto estimate = scene.Estimate(image, gravity_B);
    if (!estimate.pose) continue;
    const auto& ring = *estimate.overlay.FindEllipse("ring_outer");
    const auto poses = estimator::pad::PosesOfCircle(
        estimator::pad::NormalizedConic({ring.center, ring.semi_axes, ring.angle}, nominal.assumed_camera()),
        nominal.pad.outer_radius_m);
    if (!poses) continue;
    ++found;
    CountSelections(*poses, X_WC, X_BC, random, counts);
  }
  Json json{{"views", views}, {"found", found}, {"errors", Json::array()}};
  for (const SelectionCounts& count : counts) {
    json["errors"].push_back({{"choices", count.choices},
                              {"wrong", count.wrong},
                              {"wrong_far", count.wrong_far},
                              {"caught", count.caught},
                              {"wrong_mm", count.wrong_mm}});
  }
  return json;
}

std::string AmbiguityId(double tilt_deg) { return fmt::format("ambiguity_{:.0f}_deg", tilt_deg); }

std::string Percent(int part, int total) { return total == 0 ? "none" : util::Fixed(100.0 * part / total, 1) + " %"; }

PaperSection ReportAmbiguity(const PaperPlan& plan, const Measured& measured) {
  PaperSection section{{.id = "ambiguity", .title = "Pose ambiguity of the circle (Sec. IV-C.2)"}};
  section.paragraphs.push_back(fmt::format(
      "{} views at each tilt, from distances of 0.5, 1 and 1.5 m, with the image noise of a flight. Each ellipse of "
      "the ring gives two pose hypotheses, from which Eq. 14 selects one with a vertical that has an error in {} "
      "directions. The correct hypothesis is the one that the true vertical selects. When both are within {:.0f}° of "
      "each other, the choice hardly matters. All other wrong choices are passed to the outlier rule, one frame "
      "after a correct pose.",
      plan.ambiguity_views, kDirections, RadToDeg(kSeparation_rad)));
  report::ReportTable rates{
      .name = "ambiguity",
      .caption = "Fraction of wrong choices, by the tilt of the view and the error of the vertical.",
      .head = {"tilt, deg"}};
  for (const double error : kGravityErrors_deg) rates.head.push_back(fmt::format("{}°", error));
  report::ReportTable caught{
      .name = "ambiguity_outliers",
      .caption = fmt::format(
          "Wrong choices between hypotheses that differ by more than {:.0f}°, over all errors of the vertical.",
          RadToDeg(kSeparation_rad)),
      .head = {"tilt, deg", "wrong choices", "off by, mm", "caught by the outlier rule"}};
  std::string csv = "tilt_deg,gravity_error_deg,choices,wrong,wrong_share\n";
  for (const double tilt_deg : kAmbiguityTilts_deg) {
    const Json& errors = measured.at(AmbiguityId(tilt_deg)).at("errors");
    std::vector<std::string> cells{util::Fixed(tilt_deg, 0)};
    SelectionCounts all;
    for (std::size_t i = 0; i < kGravityErrors_deg.size(); ++i) {
      const int choices = errors[i].at("choices").get<int>(), wrong = errors[i].at("wrong").get<int>();
      cells.push_back(Percent(wrong, choices));
      csv += util::CsvLine({util::Fixed(tilt_deg, 0), util::Fixed(kGravityErrors_deg[i], 1), std::to_string(choices),
                            std::to_string(wrong),
                            choices > 0 ? util::Fixed(static_cast<double>(wrong) / choices, 5) : ""});
      all.wrong_far += errors[i].at("wrong_far").get<int>();
      all.caught += errors[i].at("caught").get<int>();
      all.wrong_mm += errors[i].at("wrong_mm").get<double>();
    }
    rates.rows.push_back(std::move(cells));
    caught.rows.push_back({util::Fixed(tilt_deg, 0), std::to_string(all.wrong_far),
                           all.wrong_far > 0 ? util::Fixed(all.wrong_mm / all.wrong_far, 0) : "none",
                           Percent(all.caught, all.wrong_far)});
  }
  section.tables = {std::move(rates), std::move(caught)};
  std::string curves;
  constexpr std::array<const char*, 7> kColors = {"MUTED", "SECOND", "ESTIMATE", "FOURTH",
                                                  "THIRD", "FIRST",  "SET_POINT"};
  for (std::size_t i = 0; i < kGravityErrors_deg.size(); ++i) {
    curves += fmt::format(
        "data using 'tilt_deg':(column('gravity_error_deg')=={0} ? 100*column('wrong_share') : NaN) with linespoints "
        "pt 7 ps 0.5 lw 1.4 lc rgb {1} title '{0} deg', \\\n",
        kGravityErrors_deg[i], kColors[i]);
  }
  section.figures.push_back(
      {.name = "ambiguity",
       .title = "Wrong choices",
       .caption = "Fraction of wrong choices over the tilt of the view, for errors of the vertical from 0 to 15°.",
       .csv = csv,
       .plot = "set key outside right title 'error of the vertical'\nset xlabel 'tilt, deg'\nset "
               "ylabel 'wrong choices, %'\nset yrange [0:*]\nset datafile missing NaN\nplot " +
               curves + "NaN notitle\n"});
  return section;
}

}  // namespace

Experiment AmbiguityExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kView_s = 0.02, kRoom_s = 3.0;
  Experiment experiment;
  for (const double tilt_deg : kAmbiguityTilts_deg) {
    experiment.measurements.push_back(
        {.id = AmbiguityId(tilt_deg),
         .expected_s = kRoom_s + kView_s * plan.ambiguity_views,
         .measure = [vehicle, tilt_deg, views = plan.ambiguity_views](const util::StopRequested& stop_requested) {
           return MeasureAmbiguity(vehicle, tilt_deg, views, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportAmbiguity(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
