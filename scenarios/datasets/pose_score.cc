#include "scenarios/datasets/pose_score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "models/error.h"
#include "models/pose_interpolation.h"
#include "scenarios/datasets/euroc_folder.h"
#include "scenarios/runner/flight_log.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/csv_table.h"
#include "scenarios/util/file.h"
#include "scenarios/util/stamped_csv.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;

/// Largest time between two true poses over which the truth is interpolated.
constexpr double kLongestGap_s = 0.05;

/// True pose at a time, interpolated between the neighboring poses; nullopt outside the truth and in gaps.
std::optional<Eigen::Isometry3d> TruthAt(const std::vector<TimedPose>& truth, double t_s) {
  const auto after =
      std::lower_bound(truth.begin(), truth.end(), t_s, [](const TimedPose& pose, double t) { return pose.t_s < t; });
  if (after == truth.end()) return std::nullopt;
  if (after->t_s == t_s) return after->X_WB;
  if (after == truth.begin() || after->t_s - (after - 1)->t_s > kLongestGap_s) return std::nullopt;
  const TimedPose& before = *(after - 1);
  const double fraction = (t_s - before.t_s) / (after->t_s - before.t_s);
  return models::InterpolatePose(before.X_WB, after->X_WB, fraction);
}

std::vector<TimedPose> ReadEurocTruth(const fs::path& file) {
  constexpr double kNanosecond_s = 1e-9;
  std::vector<TimedPose> truth;
  for (const util::StampedRow& row : util::ReadStampedCsv(file, 7)) {
    TimedPose& pose = truth.emplace_back();
    pose.t_s = static_cast<double>(row.time_ns) * kNanosecond_s;
    pose.X_WB.translation() << row.Number(0), row.Number(1), row.Number(2);
    const Eigen::Quaterniond q(row.Number(3), row.Number(4), row.Number(5), row.Number(6));
    pose.X_WB.linear() = q.normalized().toRotationMatrix();
  }
  return truth;
}

/// Frame records with status ok, one for each pose inside the truth: the pose and the true pose at its time.
std::vector<runner::FrameRecord> PairWithTruth(const std::vector<TimedPose>& poses,
                                               const std::vector<TimedPose>& truth) {
  std::vector<runner::FrameRecord> records;
  for (const TimedPose& pose : poses) {
    const auto true_pose = TruthAt(truth, pose.t_s);
    if (!true_pose) continue;
    runner::FrameRecord& record = records.emplace_back();
    record.status = estimator::FrameStatus::kOk;
    record.pose.emplace().X_WB = pose.X_WB;
    record.X_WB = *true_pose;
  }
  return records;
}

const TimedPose& Nearest(const std::vector<TimedPose>& poses, double t_s) {
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), t_s, [](const TimedPose& pose, double t) { return pose.t_s < t; });
  if (after == poses.end()) return poses.back();
  if (after == poses.begin() || after->t_s - t_s < t_s - (after - 1)->t_s) return *after;
  return *(after - 1);
}

/// Frames from the log of a flight, each with the nearest pose within half a frame period.
std::vector<runner::FrameRecord> ReadFrames(const fs::path& flight, const std::vector<TimedPose>& poses) {
  const runner::Scenario scenario = runner::LoadScenario(flight / "scenario.yaml");
  const models::CameraModel camera = scenario.assumed_camera();
  const Eigen::Isometry3d X_BC = scenario.assumed_vehicle().X_BC();
  const fs::path file = flight / "frames.csv";
  const std::string text = util::ReadTextFile(file);
  const util::CsvTable table(text, file.string());
  const std::vector<double> t_s = table.Times("t_s"), in_view = table.AllNumbers("ring_in_view");
  const auto true_u = table.Numbers("true_pad_u_px"), true_v = table.Numbers("true_pad_v_px");
  const double half_period_s = 0.5 / scenario.camera.rate_hz;

  std::vector<runner::FrameRecord> frames(table.rows());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    runner::FrameRecord& frame = frames[i];
    frame.ring_in_view = in_view[i] != 0.0;
    if (true_u[i] && true_v[i]) frame.true_pad_px.emplace(*true_u[i], *true_v[i]);
    const TimedPose& pose = Nearest(poses, t_s[i]);
    if (std::abs(pose.t_s - t_s[i]) > half_period_s) continue;
    frame.status = estimator::FrameStatus::kOk;
    const Eigen::Isometry3d X_WC = pose.X_WB * X_BC;
    frame.pad_px = camera.Project(X_WC.inverse() * Eigen::Vector3d::Zero());
  }
  return frames;
}

}  // namespace

PoseScore ScorePoses(const std::vector<TimedPose>& poses, const fs::path& truth) {
  const bool is_flight = fs::exists(truth / "truth.tum") && fs::exists(truth / "frames.csv");
  const auto recording = FindEurocFolder(truth);
  if (!is_flight && !recording) {
    throw InputError(fmt::format("{}: not a flight directory or a recording", truth.string()));
  }
  const std::vector<runner::FrameRecord> pairs =
      PairWithTruth(poses, is_flight ? ReadTumFile(truth / "truth.tum")
                                     : ReadEurocTruth(*recording / "state_groundtruth_estimate0" / "data.csv"));
  if (pairs.empty()) {
    throw InputError(fmt::format("{}: the truth covers none of the poses (from {} to {} s)", truth.string(),
                                 poses.front().t_s, poses.back().t_s));
  }
  PoseScore score{.metrics = runner::PoseErrors(pairs), .poses = pairs.size(), .outside = poses.size() - pairs.size()};
  if (is_flight) score.metrics.merge(runner::Detection(ReadFrames(truth, poses)));
  return score;
}

}  // namespace touchdown::datasets
