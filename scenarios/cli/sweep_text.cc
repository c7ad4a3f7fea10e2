#include "scenarios/cli/sweep_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace touchdown::scenarios {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPercent = 100.0;
constexpr int kSchema = 1;

std::string Percent(const PassCount& count) {
  const Interval rate = count.rate();
  return fmt::format("{:5.1f} %  ({} of {}; 95 %: {:.1f} to {:.1f})", kPercent * rate.value, count.passed, count.flown,
                     kPercent * rate.low, kPercent * rate.high);
}

/// "world.wind_m_s.0 in integer": the key, and the variant when there is one.
std::string Subject(const PassEdgeOf& each) {
  return each.variant.empty() ? each.key : fmt::format("{} in {}", each.key, each.variant);
}

/// An end that so few flights do not tell is null.
void Put(const Interval& interval, Json& json) {
  json["value"] = interval.value;
  json["low"] = interval.low;
  json["high"] = interval.high;
}

void Put(const PassCount& count, Json& json) {
  json["flown"] = count.flown;
  json["passed"] = count.passed;
  if (count.flown > 0) Put(count.rate(), json["pass_rate"]);
}

std::string Dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

DryRun MakeDryRun(const SweepPlan& plan, int jobs, const SweepStore* rows) {
  DryRun dry_run{.plan = plan, .jobs = jobs};
  double flown_s = 0.0, wall_s = 0.0;
  for (const PlannedFlight& flight : plan.flights) {
    const auto row = rows == nullptr ? std::nullopt : rows->Find(flight.id);
    if (!row) {
      dry_run.left_s += flight.expected_s;
      continue;
    }
    ++dry_run.flown;
    flown_s += flight.expected_s;
    wall_s += row->wall_s;
  }
  if (flown_s > 0.0) dry_run.pace = wall_s / flown_s;
  return dry_run;
}

std::string DryRunText(const DryRun& dry_run) {
  constexpr double kMinute_s = 60.0;
  std::string text;
  for (const PlannedFlight& flight : dry_run.plan.flights) {
    text += fmt::format("{}  seed {}", flight.id, flight.seed);
    if (!flight.variant.empty()) text += "  " + flight.variant;
    for (std::size_t i = 0; i < dry_run.plan.keys.size(); ++i)
      text += fmt::format("  {}={}", dry_run.plan.keys[i], flight.values[i]);
    text += "\n";
  }
  text += fmt::format("{} flights", dry_run.plan.flights.size());
  if (dry_run.flown > 0) text += fmt::format(", {} of them flown", dry_run.flown);
  text += fmt::format("; {:.0f} s in the air to go, about {:.1f} min on {} core{} {}\n", dry_run.left_s,
                      dry_run.left_s * dry_run.pace / kMinute_s / dry_run.jobs, dry_run.jobs,
                      dry_run.jobs == 1 ? "" : "s", dry_run.flown > 0 ? "as fast as these" : "at real time");
  return text;
}

std::string DryRunJson(const DryRun& dry_run) {
  Json json{{"schema", kSchema},
            {"planned", dry_run.plan.flights.size()},
            {"flown", dry_run.flown},
            {"expected_s", dry_run.left_s * dry_run.pace / dry_run.jobs},
            {"flights", Json::array()}};
  for (const PlannedFlight& flight : dry_run.plan.flights) {
    Json each{{"id", flight.id}, {"seed", flight.seed}};
    if (!flight.variant.empty()) each["variant"] = flight.variant;
    each["parameters"] = Json::object();
    for (std::size_t i = 0; i < dry_run.plan.keys.size(); ++i) {
      each["parameters"][dry_run.plan.keys[i]] = flight.values[i];
    }
    json["flights"].push_back(std::move(each));
  }
  return Dump(json);
}

std::string SummaryText(const SweepOutcome& sweep, const SweepSummary& summary, const std::string& out) {
  std::string text = fmt::format("{}: {} of {} flights\n", sweep.terms.name, summary.all.flown, sweep.planned);
  if (summary.all.flown > 0) {
    text += fmt::format("  passed  {}{}\n", Percent(summary.all),
                        sweep.terms.stop_when ? ", not corrected for the early stop" : "");
  }
  for (const PassCountOf& each : summary.by_value) {
    text += fmt::format("  {:<40} {}\n", fmt::format("{}={}", each.key, each.value), Percent(each.count));
  }
  for (const PassEdgeOf& each : summary.edges) {
    text += fmt::format("  {:.4g} % pass at {} = {:.4g} (95 %: {:.4g} to {:.4g}{})\n", kPercent * each.pass_rate,
                        Subject(each), each.edge.value, each.edge.low, each.edge.high,
                        each.may_lie_beyond ? ", or beyond what was flown" : "");
  }
  for (const auto& [check, interval] : summary.criteria) {
    text += fmt::format("  {}  {:<40} {:>10} {:<4} {}\n", check.pass ? "pass" : "FAIL", check.name, ValueText(check),
                        check.unit, check.limit);
  }
  if (sweep.whole > sweep.planned) {
    text += fmt::format("  {} more flights are in parts of the sweep that are not here\n", sweep.whole - sweep.planned);
  }
  return text + fmt::format("rows in {0}/sweep.db, report in {0}/report.html\n", out);
}

std::string SummaryJson(const SweepOutcome& sweep, const SweepSummary& summary, const std::string& out) {
  Json json{{"schema", kSchema}, {"version", TOUCHDOWN_VERSION}, {"sweep", sweep.terms.name}, {"planned", sweep.whole}};
  Put(summary.all, json);
  json["stale"] = sweep.stale;
  json["pass"] = summary.keeps_criteria() && summary.is_whole;
  json["parameters"] = Json::array();
  for (const PassCountOf& each : summary.by_value) {
    Json value{{"key", each.key}, {"value", each.value}};
    Put(each.count, value);
    json["parameters"].push_back(std::move(value));
  }
  json["edges"] = Json::array();
  for (const PassEdgeOf& each : summary.edges) {
    Json edge{{"key", each.key}, {"variant", each.variant}, {"pass_rate", each.pass_rate}};
    Put(each.edge, edge);
    edge["may_lie_beyond"] = each.may_lie_beyond;
    json["edges"].push_back(std::move(edge));
  }
  json["criteria"] = Json::array();
  for (const auto& [check, interval] : summary.criteria) {
    Json criterion{{"name", check.name}, {"unit", check.unit}, {"limit", check.limit}, {"pass", check.pass}};
    if (interval) Put(*interval, criterion);
    if (!check.text.empty()) criterion["value"] = check.text;
    json["criteria"].push_back(std::move(criterion));
  }
  json["rows"] = out + "/sweep.db";
  json["report"] = out + "/report.html";
  return Dump(json);
}

}  // namespace touchdown::scenarios
