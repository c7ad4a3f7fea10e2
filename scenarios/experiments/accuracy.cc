#include "scenarios/experiments/accuracy.h"

#include <array>
#include <cmath>
#include <optional>

#include "models/angles.h"
#include "models/landing_pad.h"
#include "models/random_stream.h"
#include "scenarios/experiments/circle_limit.h"
#include "scenarios/experiments/static_scene.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/text.h"
#include "sim/scene/scene.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector3d;
using models::DegToRad;
using models::RadToDeg;
using models::RandomStream;

constexpr std::array<double, 5> kDistances_m = {0.5, 0.75, 1.0, 1.25, 1.5};
constexpr std::array<double, 5> kRolls_deg = {0.0, 10.0, 20.0, 30.0, 40.0};

// Placement errors, 1-sigma, because "we manually fix the quadrotor" at each pose.
constexpr double kHandTilt_rad = DegToRad(0.5);
constexpr double kHandYaw_rad = DegToRad(2.0);
constexpr double kHandShift_m = 0.005;
// Error of the vertical measured by the IMU at rest, 1-sigma about each axis. The vertical selects between the two pose
// hypotheses of the circle.
constexpr double kGravityError_rad = DegToRad(0.5);
constexpr double kPublishedAttitude_deg = 1.5;

/// Pose of the body with the camera at a distance from the pad and the pad's center on the optical axis, plus placement
/// errors.
Eigen::Isometry3d PlacedPose(const models::Vehicle& vehicle, double distance_m, double roll_rad, RandomStream& random) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = models::RotationFromTaitBryan({.roll = roll_rad + kHandTilt_rad * random.Normal(),
                                                 .pitch = kHandTilt_rad * random.Normal(),
                                                 .yaw = kHandYaw_rad * random.Normal()});
  const Eigen::Isometry3d X_BC = vehicle.X_BC();
  const Vector3d p_WC = -distance_m * (X_WB.linear() * X_BC.linear()).col(2) + kHandShift_m * random.NormalVector3();
  X_WB.translation() = p_WC - X_WB.linear() * X_BC.translation();
  return X_WB;
}

/// Mean gray value difference between paper and ink across the outer edge of the ring in a frame.
double EdgeStep(const models::Image& image, const models::LandingPad& pad, const models::CameraModel& camera,
                const Eigen::Isometry3d& X_WC) {
  constexpr int kPoints = 24;
  const double ink_m = pad.outer_radius_m - 0.5 * pad.ring_width_m;
  const double paper_m = 0.25 * (2.0 * pad.outer_radius_m + pad.sheet_width_m);
  double step = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * models::kPi * i / kPoints;
    const auto gray = [&](double radius_m) -> double {
      const Vector3d p_W(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0);
      const Eigen::Vector2d pixel = camera.Project(X_WC.inverse() * p_W).value();
      return image.View().At(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    };
    step += (gray(paper_m) - gray(ink_m)) / kPoints;
  }
  return step;
}

/// Sums of the errors over the frames of a placement: position error in W, m, and roll and pitch error, rad.
struct ErrorSums {
  int frames = 0;
  Vector3d position = Vector3d::Zero();
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  double position_squares = 0.0;
  double tilt_squares = 0.0;

  void Add(const Eigen::Isometry3d& estimate, const Eigen::Isometry3d& truth) {
    const models::TaitBryan true_angles = models::TaitBryanFromRotation(truth.linear());
    const Eigen::Isometry3d X_WB = models::ResolveYawAmbiguity(estimate, true_angles.yaw);
    const models::TaitBryan estimated_angles = models::TaitBryanFromRotation(X_WB.linear());
    const Vector3d position_error = X_WB.translation() - truth.translation();
    const Eigen::Vector2d tilt_error(models::WrapToPi(estimated_angles.roll - true_angles.roll),
                                     estimated_angles.pitch - true_angles.pitch);
    position += position_error;
    tilt += tilt_error;
    position_squares += position_error.squaredNorm();
    tilt_squares += tilt_error.squaredNorm();
    ++frames;
  }
};

Json CellJson(const ErrorSums& sums, int frames, double noise_fraction, const std::optional<CircleLimit>& limit) {
  Json json{{"frames", frames}, {"found", sums.frames}, {"noise_share", noise_fraction}};
  const double n = std::max(1, sums.frames);
  json["position_square_mm2"] = 1e6 * sums.position_squares / n;
  json["position_mean_square_mm2"] = 1e6 * (sums.position / n).squaredNorm();
  json["tilt_square_deg2"] = std::pow(RadToDeg(1.0), 2) * sums.tilt_squares / n;
  json["tilt_mean_square_deg2"] = std::pow(RadToDeg(1.0), 2) * (sums.tilt / n).squaredNorm();
  if (limit) {
    json["position_limit_mm"] = 1e3 * limit->position_m;
    json["tilt_limit_deg"] = RadToDeg(limit->tilt_rad);
  }
  return json;
}

/// Places the vehicle once in each cell, in a room of the placement's own seed. The frames of a cell differ only in
/// their noise.
Json MeasurePlacement(const PaperVehicle& vehicle, int placement, int frames,
                      const util::StopRequested& stop_requested) {
  const auto seed = static_cast<std::uint64_t>(1 + placement);
  RandomStream random(seed, "paper.accuracy.hand");
  runner::Scenario nominal;
  vehicle.ApplyTo(nominal);
  const models::CameraModel camera = nominal.camera.model;
  StaticScene scene(nominal, sim::MakeScene({}, nominal.pad, seed), seed);
  Json cells = Json::array();
  for (const double distance_m : kDistances_m) {
    for (const double roll_deg : kRolls_deg) {
      if (stop_requested && stop_requested()) throw util::Interrupted();
      const Eigen::Isometry3d X_WB = PlacedPose(vehicle.truth, distance_m, DegToRad(roll_deg), random);
      const Eigen::Isometry3d X_WC = X_WB * vehicle.truth.X_BC();
      const Vector3d gravity_error(kGravityError_rad * random.Normal(), kGravityError_rad * random.Normal(), 0.0);
      const Vector3d gravity_B = models::RotationExp(gravity_error) * DownInBody(X_WB);
      ErrorSums sums;
      models::Image image = scene.Capture({.X_WC = X_WC});
      const double noise_fraction = StaticScene::kFlightNoise[0] / EdgeStep(image, nominal.pad, camera, X_WC);
      for (int frame = 0; frame < frames; ++frame) {
        if (frame > 0) image = scene.CaptureAgain();
        const auto estimate = scene.Estimate(image, gravity_B);
        if (estimate.pose) sums.Add(estimate.pose->X_WB, X_WB);
      }
      cells.push_back(CellJson(sums, frames, noise_fraction,
                               LimitForCircle(camera, nominal.pad.outer_radius_m, X_WC, noise_fraction)));
    }
  }
  return cells;
}

/// Statistics of a cell over all placements. The mean error of a placement is systematic, the remainder is random.
struct Cell {
  double distance_m = 0.0, roll_deg = 0.0;
  int frames = 0, found = 0;
  double position_rmse_mm = 0.0, position_systematic_mm = 0.0, position_random_mm = 0.0;
  double tilt_rmse_deg = 0.0, tilt_systematic_deg = 0.0, tilt_random_deg = 0.0;
  std::optional<double> position_limit_mm = std::nullopt, tilt_limit_deg = std::nullopt;
};

std::string AccuracyId(int placement) { return fmt::format("accuracy_{}", 1 + placement); }

Cell SumCell(const Measured& measured, int placements, std::size_t index) {
  Cell cell{.distance_m = kDistances_m[index / kRolls_deg.size()], .roll_deg = kRolls_deg[index % kRolls_deg.size()]};
  double position = 0.0, position_mean = 0.0, tilt = 0.0, tilt_mean = 0.0, position_limit = 0.0, tilt_limit = 0.0;
  bool has_limit = true;
  for (int i = 0; i < placements; ++i) {
    const Json& json = measured.at(AccuracyId(i)).at(index);
    cell.frames += json.at("frames").get<int>();
    cell.found += json.at("found").get<int>();
    position += json.at("position_square_mm2").get<double>() / placements;
    position_mean += json.at("position_mean_square_mm2").get<double>() / placements;
    tilt += json.at("tilt_square_deg2").get<double>() / placements;
    tilt_mean += json.at("tilt_mean_square_deg2").get<double>() / placements;
    has_limit = has_limit && json.contains("tilt_limit_deg");
    if (!has_limit) continue;
    position_limit += std::pow(json.at("position_limit_mm").get<double>(), 2) / placements;
    tilt_limit += std::pow(json.at("tilt_limit_deg").get<double>(), 2) / placements;
  }
  cell.position_rmse_mm = std::sqrt(position);
  cell.position_systematic_mm = std::sqrt(position_mean);
  cell.position_random_mm = std::sqrt(std::max(0.0, position - position_mean));
  cell.tilt_rmse_deg = std::sqrt(tilt);
  cell.tilt_systematic_deg = std::sqrt(tilt_mean);
  cell.tilt_random_deg = std::sqrt(std::max(0.0, tilt - tilt_mean));
  if (has_limit) {
    cell.position_limit_mm = std::sqrt(position_limit);
    cell.tilt_limit_deg = std::sqrt(tilt_limit);
  }
  return cell;
}

std::string CellsCsv(const std::vector<Cell>& cells) {
  std::string csv =
      "distance_m,roll_deg,frames,found,position_rmse_mm,position_systematic_mm,position_random_mm,position_limit_mm,"
      "attitude_rmse_deg,attitude_systematic_deg,attitude_random_deg,attitude_limit_deg\n";
  const auto or_none = [](const std::optional<double>& value) {
    return value ? util::Fixed(*value, 4) : std::string();
  };
  for (const Cell& cell : cells) {
    csv += util::CsvLine(
        {util::Fixed(cell.distance_m, 2), util::Fixed(cell.roll_deg, 0), std::to_string(cell.frames),
         std::to_string(cell.found), util::Fixed(cell.position_rmse_mm, 3), util::Fixed(cell.position_systematic_mm, 3),
         util::Fixed(cell.position_random_mm, 3), or_none(cell.position_limit_mm), util::Fixed(cell.tilt_rmse_deg, 4),
         util::Fixed(cell.tilt_systematic_deg, 4), util::Fixed(cell.tilt_random_deg, 4), or_none(cell.tilt_limit_deg)});
  }
  return csv;
}

/// Plot over roll with one line for each distance, and dashed the bounds for the smallest and the largest distance.
std::string PlotOverRoll(const std::string& column, const std::string& limit, const std::string& label) {
  constexpr std::array<const char*, 5> kColors = {"SECOND", "ESTIMATE", "FOURTH", "FIRST", "SET_POINT"};
  std::string curves;
  for (std::size_t i = 0; i < kDistances_m.size(); ++i) {
    curves += fmt::format(
        "data using 'roll_deg':(column('distance_m')=={0} ? column('{1}') : NaN) with linespoints pt 7 ps 0.6 lw 1.6 "
        "lc rgb {2} title '{0} m', \\\n",
        kDistances_m[i], column, kColors[i]);
  }
  for (const std::size_t i : {std::size_t{0}, kDistances_m.size() - 1}) {
    curves += fmt::format(
        "data using 'roll_deg':(column('distance_m')=={0} ? column('{1}') : NaN) with lines dt 2 lw 1.2 lc rgb {2} "
        "title 'limit, {0} m', \\\n",
        kDistances_m[i], limit, kColors[i]);
  }
  return fmt::format(
      "set key outside right\nset xlabel 'roll, deg'\nset ylabel '{}'\nset yrange [0:*]\nset xrange [-2:42]\nset "
      "datafile missing NaN\nplot {}NaN notitle\n",
      label, curves);
}

PaperSection ReportAccuracy(const PaperPlan& plan, const Measured& measured) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < kDistances_m.size() * kRolls_deg.size(); ++i) {
    cells.push_back(SumCell(measured, plan.placements, i));
  }
  PaperSection section{{.id = "accuracy", .title = "5 DOF accuracy (Sec. VI-B.5, Fig. 10)"}};
  section.paragraphs = {fmt::format(
      "The vehicle is at rest with the center of the pad on the optical axis. Each cell has {} placements, each in its "
      "own room, with {} frames each. The mean error of a placement is systematic (calibration, pixel grid); the "
      "remaining error of its frames is random. The attitude error combines roll and pitch. The vertical that selects "
      "between the two pose hypotheses of the circle has an error of 0.5° (1 sigma) about each axis. The limit is the "
      "Cram&eacute;r-Rao bound for the outer edge of the ring alone, with ideally sharp pixels and the noise and "
      "contrast of the frames. It applies to the random part. It does not exist for a frontal view, where a tilt moves "
      "the edge in the same way as a translation. At large roll most of the position error is systematic: the oblique "
      "view of the H causes a yaw error, which rotates the position about the pad.",
      plan.placements, plan.frames_per_placement)};
  const std::string csv = CellsCsv(cells);
  section.figures.push_back({.name = "fig_10a_position",
                             .title = "Fig. 10a: position",
                             .caption = "RMSE of the 3D position over roll, for each distance. Dashed: the limit.",
                             .csv = csv,
                             .plot = PlotOverRoll("position_rmse_mm", "position_limit_mm", "position RMSE, mm")});
  section.figures.push_back({.name = "fig_10b_attitude",
                             .title = "Fig. 10b: attitude",
                             .caption = "RMSE of the attitude over roll, for each distance. Dashed: the limit.",
                             .csv = csv,
                             .plot = PlotOverRoll("attitude_rmse_deg", "attitude_limit_deg", "attitude RMSE, deg")});
  report::ReportTable table{
      .name = "fig_10_cells",
      .caption = "Position (mm) and attitude (deg): RMSE, systematic part, random part, and limit of the random part.",
      .head = {"distance, m", "roll, deg", "found", "position", "syst.", "random", "limit", "attitude", "syst.",
               "random", "limit"}};
  const Cell* worst = &cells.front();
  for (const Cell& cell : cells) {
    const auto or_none = [](const std::optional<double>& value, int digits) {
      return value ? util::Fixed(*value, digits) : std::string("none");
    };
    table.rows.push_back({util::Fixed(cell.distance_m, 2), util::Fixed(cell.roll_deg, 0),
                          util::Fixed(100.0 * cell.found / cell.frames, 1) + " %",
                          util::Fixed(cell.position_rmse_mm, 1), util::Fixed(cell.position_systematic_mm, 1),
                          util::Fixed(cell.position_random_mm, 1), or_none(cell.position_limit_mm, 1),
                          util::Fixed(cell.tilt_rmse_deg, 2), util::Fixed(cell.tilt_systematic_deg, 2),
                          util::Fixed(cell.tilt_random_deg, 2), or_none(cell.tilt_limit_deg, 2)});
    if (cell.tilt_rmse_deg > worst->tilt_rmse_deg) worst = &cell;
  }
  section.tables.push_back(std::move(table));
  section.compared.push_back(
      {.quantity = "Attitude RMSE, worst cell of Fig. 10",
       .unit = "deg",
       .published = kPublishedAttitude_deg,
       .ours = worst->tilt_rmse_deg,
       .spread = fmt::format("at {:.2f} m and {:.0f}° of roll", worst->distance_m, worst->roll_deg),
       .why = "Roll and pitch combined. In nearly frontal views the tilt of a circle is hardly observable (see the "
              "limit)."});
  return section;
}

}  // namespace

Experiment AccuracyExperiment(const PaperPlan& plan, const PaperVehicle& vehicle) {
  constexpr double kFrame_s = 0.008, kRoom_s = 3.0;
  Experiment experiment;
  for (int i = 0; i < plan.placements; ++i) {
    experiment.measurements.push_back(
        {.id = AccuracyId(i),
         .expected_s = kRoom_s + kFrame_s * plan.frames_per_placement * kDistances_m.size() * kRolls_deg.size(),
         .measure = [vehicle, i, frames = plan.frames_per_placement](const util::StopRequested& stop_requested) {
           return MeasurePlacement(vehicle, i, frames, stop_requested);
         }});
  }
  experiment.report = [plan](const Measured& measured) { return ReportAccuracy(plan, measured); };
  return experiment;
}

}  // namespace touchdown::experiments
