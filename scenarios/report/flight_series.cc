#include "scenarios/report/flight_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "models/angles.h"
#include "models/error.h"
#include "models/landing_pad.h"
#include "scenarios/util/csv_table.h"

namespace touchdown::report {
namespace {

using Span = FlightSeries::Span;

PoseSeries ReadPose(const util::CsvTable& table, const std::string& prefix) {
  return {table.Numbers(prefix + "x_m"),      table.Numbers(prefix + "y_m"),       table.Numbers(prefix + "z_m"),
          table.Numbers(prefix + "roll_deg"), table.Numbers(prefix + "pitch_deg"), table.Numbers(prefix + "yaw_deg")};
}

/// `angle` plus the multiple of `period` that brings it nearest to `target`.
double Nearest(double angle, double target, double period) {
  return angle + period * std::round((target - angle) / period);
}

/// Removes jumps by 360 degrees.
void Unwrap(Series& yaw_deg) {
  std::optional<double> previous;
  for (std::optional<double>& yaw : yaw_deg) {
    if (yaw && previous) yaw = Nearest(*yaw, *previous, 360.0);
    if (yaw) previous = yaw;
  }
}

/// Unwraps each yaw towards the latest preceding value of another, unwrapped series.
void UnwrapTowards(const std::vector<double>& other_t_s, const Series& other_deg, const std::vector<double>& t_s,
                   Series& yaw_deg) {
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const auto after = std::upper_bound(other_t_s.begin(), other_t_s.end(), t_s[i]);
    if (after == other_t_s.begin() || !yaw_deg[i]) continue;
    const std::optional<double> other = other_deg[static_cast<std::size_t>(after - other_t_s.begin()) - 1];
    if (other) yaw_deg[i] = Nearest(*yaw_deg[i], *other, 360.0);
  }
}

/// Resolves each pose's 180-degree yaw ambiguity by the true yaw, as models::ResolveYawAmbiguity does, and unwraps its
/// yaw towards it.
void ResolveYawAmbiguities(PoseSeries& poses, const Series& true_yaw_deg) {
  for (std::size_t i = 0; i < true_yaw_deg.size(); ++i) {
    if (!poses.yaw_deg[i] || !true_yaw_deg[i]) continue;
    const bool rotate =
        models::HalfTurnIsNearer(models::DegToRad(*poses.yaw_deg[i]), models::DegToRad(*true_yaw_deg[i]));
    poses.yaw_deg[i] = Nearest(*poses.yaw_deg[i] + (rotate ? 180.0 : 0.0), *true_yaw_deg[i], 360.0);
    if (rotate && poses.x_m[i]) poses.x_m[i] = -*poses.x_m[i];
    if (rotate && poses.y_m[i]) poses.y_m[i] = -*poses.y_m[i];
  }
}

/// Removes the poses of the rows for whose name `is_removed` returns true.
template <typename IsRemoved>
void Remove(PoseSeries& poses, const std::vector<std::string_view>& names, const IsRemoved& is_removed) {
  for (Series* series : poses.all()) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_removed(names[i])) (*series)[i] = std::nullopt;
    }
  }
}

/// Merges successive rows of equal name into spans. A span ends at the next row; the last span, and a span before a
/// gap, ends `period_s` after its last row.
std::vector<Span> SpansOf(const std::vector<std::string_view>& names, const std::vector<double>& t_s, double period_s) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool continues = i > 0 && names[i] == spans.back().name && t_s[i] - t_s[i - 1] <= kMissingFrame * period_s;
    if (!continues) spans.push_back({std::string(names[i]), t_s[i], t_s[i]});
    const bool next_is_near = i + 1 < names.size() && t_s[i + 1] - t_s[i] <= kMissingFrame * period_s;
    spans.back().to_s = next_is_near ? t_s[i + 1] : t_s[i] + period_s;
  }
  return spans;
}

void ReadTicks(const FlightFiles& files, FlightSeries& flight) {
  const util::CsvTable table(files.flight_csv, files.NameOf("flight.csv"));
  flight.t_s = table.Times("t_s");
  flight.truth = ReadPose(table, "true_");
  flight.estimate = ReadPose(table, "est_");
  flight.set_point = ReadPose(table, "set_");
  for (std::size_t i = 0; i < flight.command_rad_s.size(); ++i) {
    flight.command_rad_s[i] = table.Numbers(fmt::format("command{}_rad_s", i));
  }
  Unwrap(flight.truth.yaw_deg);
  ResolveYawAmbiguities(flight.estimate, flight.truth.yaw_deg);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::optional<double>& yaw = flight.set_point.yaw_deg[i];
    if (yaw && flight.truth.yaw_deg[i]) yaw = Nearest(*yaw, *flight.truth.yaw_deg[i], 180.0);
  }
  const std::vector<std::string_view> phases = table.Texts("phase");
  Remove(flight.set_point, phases, [](std::string_view phase) { return phase == "standby" || phase == "touchdown"; });
  const double longest_step_s = flight.t_s.empty() ? 0.0 : flight.t_s.back() - flight.t_s.front();
  flight.phases = SpansOf(phases, flight.t_s, longest_step_s);
  if (!flight.phases.empty()) flight.phases.back().to_s = flight.t_s.back();
}

Series ReadVisionTime(const FlightFiles& files, const std::vector<double>& frame_ticks) {
  const std::string name = files.NameOf("frame_timing.csv");
  const util::CsvTable table(files.frame_timing_csv, name);
  if (table.AllNumbers("tick") != frame_ticks) {
    throw InputError(fmt::format("{}:1: tick: must equal the column tick of frames.csv", name));
  }
  return table.Numbers("vision_ms");
}

void ReadFrames(const FlightFiles& files, double frame_period_s, FlightSeries& flight) {
  const util::CsvTable table(files.frames_csv, files.NameOf("frames.csv"));
  flight.frame_t_s = table.Times("t_s");
  flight.frame_truth = ReadPose(table, "true_");
  flight.vision = ReadPose(table, "");
  UnwrapTowards(flight.t_s, flight.truth.yaw_deg, flight.frame_t_s, flight.frame_truth.yaw_deg);
  ResolveYawAmbiguities(flight.vision, flight.frame_truth.yaw_deg);
  const std::vector<std::string_view> statuses = table.Texts("status");
  Remove(flight.vision, statuses, [](std::string_view status) { return status != "ok"; });
  flight.statuses = SpansOf(statuses, flight.frame_t_s, frame_period_s);
  flight.vision_ms = ReadVisionTime(files, table.AllNumbers("tick"));
}

}  // namespace

FlightSeries ReadFlightSeries(const FlightFiles& files, double frame_period_s) {
  FlightSeries flight;
  ReadTicks(files, flight);
  ReadFrames(files, frame_period_s, flight);
  if (!flight.t_s.empty()) flight.duration_s = flight.t_s.back();
  return flight;
}

}  // namespace touchdown::report
