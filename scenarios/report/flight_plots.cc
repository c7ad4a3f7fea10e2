#include "scenarios/report/flight_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "models/pad_outline.h"

namespace touchdown::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kBuckets = 1100;
constexpr double kMillimeters = 1000.0;

// Result of a frame, in the order of the processing stages; `ok` is a pose.
constexpr std::array<std::string_view, 7> kStages = {"no_component", "no_circle", "no_h", "no_pair",
                                                     "no_ellipse",   "outlier",   "ok"};

/// A series with its legend label. The role selects color and line style on the page.
struct Curve {
  std::string label;
  std::string role;
  Series values;
};

/// Curves that share one time vector.
struct Sheet {
  std::vector<double> t_s;
  std::vector<Curve> curves;
};

/// Rounds to `digits` decimals.
Json Rounded(double value, int digits) {
  const double scale = std::pow(10.0, std::abs(digits));
  const double rounded = digits >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
  return rounded + 0.0;  // No negative zero.
}

Json Time(double t_s) { return Rounded(t_s, 4); }

/// Rounds to five significant digits; null for nullopt.
Json Significant(std::optional<double> value) {
  constexpr int kDigits = 5;
  if (!value) return nullptr;
  if (*value == 0.0) return 0.0;
  return Rounded(*value, kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(*value)))));
}

Json SheetJson(const Sheet& sheet) {
  std::vector<Series> series;
  for (const Curve& curve : sheet.curves) series.push_back(curve.values);
  const std::vector<std::size_t> rows = ThinnedRows(series, kBuckets);
  Json json{{"t_s", Json::array()}, {"series", Json::array()}};
  for (const std::size_t row : rows) json["t_s"].push_back(Time(sheet.t_s[row]));
  for (const Curve& curve : sheet.curves) {
    Json values = Json::array();
    for (const std::size_t row : rows) values.push_back(Significant(curve.values[row]));
    json["series"].push_back({{"label", curve.label}, {"role", curve.role}, {"values", std::move(values)}});
  }
  return json;
}

Json PlotJson(std::string_view section, std::string_view title, std::string_view unit,
              const std::vector<Sheet>& sheets) {
  Json json{{"section", section}, {"title", title}, {"unit", unit}, {"sheets", Json::array()}};
  for (const Sheet& sheet : sheets) json["sheets"].push_back(SheetJson(sheet));
  return json;
}

/// (`a` - `b`) * `scale` where both have a value.
Series Difference(const Series& a, const Series& b, double scale = 1.0) {
  Series difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] && b[i]) difference[i] = (*a[i] - *b[i]) * scale;
  }
  return difference;
}

/// Removes the values at which `mask` has no value.
Series Masked(Series values, const Series& mask) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) values[i] = std::nullopt;
  }
  return values;
}

/// Inserts an empty row wherever frames are missing, so that no line crosses the gap.
Sheet WithGaps(const Sheet& sheet, double period_s) {
  Sheet gapped;
  for (const Curve& curve : sheet.curves) gapped.curves.push_back({curve.label, curve.role, {}});
  for (std::size_t i = 0; i < sheet.t_s.size(); ++i) {
    if (i > 0 && sheet.t_s[i] - sheet.t_s[i - 1] > kMissingFrame * period_s) {
      gapped.t_s.push_back((sheet.t_s[i] + sheet.t_s[i - 1]) / 2.0);
      for (Curve& curve : gapped.curves) curve.values.emplace_back();
    }
    gapped.t_s.push_back(sheet.t_s[i]);
    for (std::size_t k = 0; k < sheet.curves.size(); ++k) {
      gapped.curves[k].values.push_back(sheet.curves[k].values[i]);
    }
  }
  return gapped;
}

/// Plot of one coordinate: truth, set-point, estimate and vision.
Json CoordinateJson(const FlightSeries& flight, std::string_view section, std::string_view title, std::string_view unit,
                    Series PoseSeries::*coordinate) {
  const Sheet frames{flight.frame_t_s, {{"vision", "vision", flight.vision.*coordinate}}};
  const Sheet ticks{flight.t_s,
                    {{"truth", "truth", flight.truth.*coordinate},
                     {"set-point", "set-point", flight.set_point.*coordinate},
                     {"estimate", "estimate", flight.estimate.*coordinate}}};
  return PlotJson(section, title, unit, {frames, ticks});
}

std::vector<Curve> PositionErrors(const PoseSeries& pose, const PoseSeries& reference) {
  return {{"x", "first", Difference(pose.x_m, reference.x_m, kMillimeters)},
          {"y", "second", Difference(pose.y_m, reference.y_m, kMillimeters)},
          {"z", "third", Difference(pose.z_m, reference.z_m, kMillimeters)}};
}

std::vector<Curve> AttitudeErrors(const PoseSeries& pose, const PoseSeries& reference) {
  return {{"roll", "first", Difference(pose.roll_deg, reference.roll_deg)},
          {"pitch", "second", Difference(pose.pitch_deg, reference.pitch_deg)},
          {"yaw", "third", Difference(pose.yaw_deg, reference.yaw_deg)}};
}

/// Lane plot with one lane per stage, "ok" on top. A bar spans the frames whose processing ended at that stage.
Json StagesJson(const FlightSeries& flight) {
  Json json{{"section", "Vision"}, {"title", "Detection"}, {"lanes", Json::array()}};
  for (const std::string_view stage : kStages) {
    Json bars = Json::array();
    for (const FlightSeries::Span& span : flight.statuses) {
      if (span.name == stage) bars.push_back({Time(span.from_s), Time(span.to_s)});
    }
    json["lanes"].push_back({{"label", stage}, {"bars", std::move(bars)}});
  }
  return json;
}

Json VisionTimeJson(const FlightSeries& flight, double frame_period_s) {
  const Sheet sheet{flight.frame_t_s, {{"time", "estimate", flight.vision_ms}}};
  return PlotJson("Vision", "Vision time per frame", "ms", {WithGaps(sheet, frame_period_s)});
}

/// Commands while the motors run. The zeros before and after would enlarge the range and hide the differences.
Json RotorsJson(const FlightSeries& flight) {
  constexpr std::array<const char*, 4> kLineRoles = {"first", "second", "third", "fourth"};
  Sheet sheet{flight.t_s, {}};
  for (std::size_t i = 0; i < flight.command_rad_s.size(); ++i) {
    sheet.curves.push_back(
        {fmt::format("rotor {}", i), kLineRoles[i], Masked(flight.command_rad_s[i], flight.set_point.z_m)});
  }
  return PlotJson("Rotors", "Rotor commands", "rad/s", {sheet});
}

/// Errors while the motors run. Afterwards the estimate is not used.
std::vector<Curve> EstimateErrors(const FlightSeries& flight) {
  std::vector<Curve> errors = PositionErrors(flight.estimate, flight.truth);
  for (Curve& curve : errors) curve.values = Masked(std::move(curve.values), flight.set_point.z_m);
  return errors;
}

Json PlotsJson(const FlightSeries& flight, double frame_period_s) {
  const auto frames = [&](std::vector<Curve> curves) {
    return std::vector{WithGaps({flight.frame_t_s, std::move(curves)}, frame_period_s)};
  };
  const auto ticks = [&](std::vector<Curve> curves) { return std::vector{Sheet{flight.t_s, std::move(curves)}}; };
  return {CoordinateJson(flight, "Position", "x", "m", &PoseSeries::x_m),
          CoordinateJson(flight, "Position", "y", "m", &PoseSeries::y_m),
          CoordinateJson(flight, "Position", "z, height", "m", &PoseSeries::z_m),
          CoordinateJson(flight, "Attitude", "Roll", "deg", &PoseSeries::roll_deg),
          CoordinateJson(flight, "Attitude", "Pitch", "deg", &PoseSeries::pitch_deg),
          CoordinateJson(flight, "Attitude", "Yaw", "deg", &PoseSeries::yaw_deg),
          PlotJson("Errors", "Vision position error (unfiltered, vision minus truth)", "mm",
                   frames(PositionErrors(flight.vision, flight.frame_truth))),
          PlotJson("Errors", "Vision attitude error (unfiltered, vision minus truth)", "deg",
                   frames(AttitudeErrors(flight.vision, flight.frame_truth))),
          PlotJson("Errors", "Estimated position error (estimate minus truth)", "mm", ticks(EstimateErrors(flight))),
          PlotJson("Errors", "Position control error (truth minus set-point)", "mm",
                   ticks(PositionErrors(flight.truth, flight.set_point))),
          StagesJson(flight),
          VisionTimeJson(flight, frame_period_s),
          RotorsJson(flight)};
}

/// Ground track for the top view: true position and yaw, set-point and vision position.
Json TrackJson(const FlightSeries& flight) {
  return {{"ticks", SheetJson({flight.t_s,
                               {{"x", "truth", flight.truth.x_m},
                                {"y", "truth", flight.truth.y_m},
                                {"yaw", "truth", flight.truth.yaw_deg},
                                {"x", "set-point", flight.set_point.x_m},
                                {"y", "set-point", flight.set_point.y_m}}})},
          {"frames",
           SheetJson({flight.frame_t_s, {{"x", "vision", flight.vision.x_m}, {"y", "vision", flight.vision.y_m}}})}};
}

Json SpansJson(const std::vector<FlightSeries::Span>& spans) {
  Json json = Json::array();
  for (const FlightSeries::Span& span : spans) {
    json.push_back({{"name", span.name}, {"from_s", Time(span.from_s)}, {"to_s", Time(span.to_s)}});
  }
  return json;
}

/// Events that began before the end of the flight.
Json EventsJson(const std::vector<runner::Event>& events, double duration_s) {
  Json json = Json::array();
  for (const runner::Event& event : events) {
    if (event.at_s > duration_s) continue;
    const double to_s = std::min(event.at_s + event.duration_s, duration_s);
    json.push_back({{"name", event.Label()}, {"from_s", Time(event.at_s)}, {"to_s", Time(to_s)}});
  }
  return json;
}

Json PointJson(const Eigen::Vector2d& p) { return {Significant(p.x()), Significant(p.y())}; }

Json ShapeJson(const models::PadShape& shape) {
  Json json{{"color", shape.color == models::PadShape::Color::kBlack ? "black" : "white"}};
  if (const auto* circle = std::get_if<models::Circle>(&shape.outline)) {
    json["center_m"] = PointJson(circle->center_m);
    json["radius_m"] = Significant(circle->radius_m);
  } else {
    for (const Eigen::Vector2d& corner : std::get<models::Polygon>(shape.outline).corners_m) {
      json["corners_m"].push_back(PointJson(corner));
    }
  }
  return json;
}

/// Sheet size and shapes of the pad in W, in drawing order.
Json PadJson(const models::LandingPad& pad) {
  Json json{{"sheet_length_m", pad.sheet_length_m}, {"sheet_width_m", pad.sheet_width_m}};
  const models::PadOutline outline(pad);
  for (const models::PadShape& shape : outline.shapes()) json["shapes"].push_back(ShapeJson(shape));
  return json;
}

}  // namespace

Json FlightPlots(const FlightSeries& flight, const std::optional<Touchdown>& touchdown,
                 const runner::Scenario& scenario) {
  Json json;
  json["duration_s"] = Time(flight.duration_s);
  json["phases"] = SpansJson(flight.phases);
  json["events"] = EventsJson(scenario.events, flight.duration_s);
  json["touchdown"] = nullptr;
  if (touchdown) {
    json["touchdown"] = {
        {"t_s", Time(touchdown->t_s)}, {"x_m", Significant(touchdown->x_m)}, {"y_m", Significant(touchdown->y_m)}};
  }
  json["pad"] = scenario.scene.pad ? PadJson(scenario.pad) : Json(nullptr);
  json["track"] = TrackJson(flight);
  json["plots"] = PlotsJson(flight, 1.0 / scenario.camera.rate_hz);
  return json;
}

}  // namespace touchdown::report
