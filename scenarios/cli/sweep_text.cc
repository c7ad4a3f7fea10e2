#include "scenarios/cli/sweep_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/sweeper/plan/parameter_json.h"
#include "scenarios/util/version.h"

namespace touchdown::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPercent = 100.0;
constexpr int kSchema = 1;

std::string Percent(const sweeper::PassCount& count) {
  const util::Interval rate = count.rate();
  const int seeds = static_cast<int>(count.seeds.size());
  return fmt::format("{:5.1f} %  ({} of {}{}; 95 %: {:.1f} to {:.1f})", kPercent * rate.value, count.passed,
                     count.flown, seeds < count.flown ? fmt::format(", {} seeds", seeds) : "", kPercent * rate.low,
                     kPercent * rate.high);
}

/// The interval as " (95 %: 0.97 to 0.99)". A bound that the flights do not determine is printed as "?".
std::string IntervalText(const std::optional<util::Interval>& interval) {
  if (!interval) return "";
  const auto bound = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("?");
  };
  return fmt::format(" (95 %: {} to {})", bound(interval->low), bound(interval->high));
}

/// The key, with its variant if any, such as "world.wind_m_s.0 in integer".
std::string Subject(const sweeper::PassBoundaryOf& each) {
  return each.variant.empty() ? each.key : fmt::format("{} in {}", each.key, each.variant);
}

std::string BoundaryText(const sweeper::PassBoundaryOf& each,
                         const std::optional<sweeper::SearchedBoundary>& searched) {
  const double percent = kPercent * each.pass_rate;
  if (!each.boundary) {
    return fmt::format(
        "  no value of {} from {:.4g} to {:.4g} found at which {:.4g} % pass: the results do not change\n", each.key,
        searched->min, searched->max, percent);
  }
  return fmt::format("  {:.4g} % pass at {} = {:.4g} (95 %: {:.4g} to {:.4g}{})\n", percent, Subject(each),
                     each.boundary->value, each.boundary->low, each.boundary->high,
                     each.may_lie_beyond ? ", or outside the flown range" : "");
}

/// A bound that is not finite becomes null in JSON.
void Put(const util::Interval& interval, Json& json) {
  json["value"] = interval.value;
  json["low"] = interval.low;
  json["high"] = interval.high;
}

void Put(const sweeper::PassCount& count, Json& json) {
  json["flown"] = count.flown;
  json["seeds"] = count.seeds.size();
  json["passed"] = count.passed;
  if (count.flown > 0) Put(count.rate(), json["pass_rate"]);
}

std::string Dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

DryRun MakeDryRun(const sweeper::SweepPlan& plan, int jobs, const sweeper::SweepStore* rows) {
  DryRun dry_run{.plan = plan, .jobs = jobs};
  double flown_s = 0.0, wall_s = 0.0;
  for (const sweeper::PlannedFlight& flight : plan.flights) {
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
  for (const sweeper::PlannedFlight& flight : dry_run.plan.flights) {
    text += fmt::format("{}  seed {}", flight.id, flight.seed);
    if (!flight.variant.empty()) text += "  " + flight.variant;
    for (std::size_t i = 0; i < dry_run.plan.keys.size(); ++i)
      text += fmt::format("  {}={}", dry_run.plan.keys[i], flight.values[i]);
    text += "\n";
  }
  text += fmt::format("{} flights", dry_run.plan.flights.size());
  if (dry_run.flown > 0) text += fmt::format(", {} of them flown", dry_run.flown);
  const double expected_s = dry_run.left_s * dry_run.pace / dry_run.jobs;
  text += fmt::format("; {:.0f} s of simulated time remain, about {} on {} core{} {}\n", dry_run.left_s,
                      expected_s < kMinute_s ? fmt::format("{:.0f} s", std::ceil(expected_s))
                                             : fmt::format("{:.1f} min", expected_s / kMinute_s),
                      dry_run.jobs, dry_run.jobs == 1 ? "" : "s",
                      dry_run.flown > 0 ? "at the speed of the flown ones" : "at real time");
  return text;
}

std::string DryRunJson(const DryRun& dry_run) {
  Json json{{"schema", kSchema},
            {"planned", dry_run.plan.flights.size()},
            {"flown", dry_run.flown},
            {"expected_s", dry_run.left_s * dry_run.pace / dry_run.jobs},
            {"flights", Json::array()}};
  for (const sweeper::PlannedFlight& flight : dry_run.plan.flights) {
    Json each{{"id", flight.id}, {"seed", flight.seed}};
    if (!flight.variant.empty()) each["variant"] = flight.variant;
    each["parameters"] = Json::object();
    for (std::size_t i = 0; i < dry_run.plan.keys.size(); ++i) {
      each["parameters"][dry_run.plan.keys[i]] = sweeper::ParameterJson(flight.values[i]);
    }
    json["flights"].push_back(std::move(each));
  }
  return Dump(json);
}

std::string SummaryText(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out) {
  std::string text = fmt::format("{}: {} of {} flights\n", sweep.spec.name, summary.all.flown, sweep.planned);
  if (summary.all.flown > 0 && !sweep.spec.search) {
    text += fmt::format("  passed  {}{}\n", Percent(summary.all),
                        sweep.spec.stop_when ? ", not corrected for the early stop" : "");
  }
  for (const sweeper::PassCountOf& each : summary.by_value) {
    text += fmt::format("  {:<40} {}\n", fmt::format("{}={}", each.key, each.value), Percent(each.count));
  }
  for (const sweeper::PassBoundaryOf& each : summary.boundaries) text += BoundaryText(each, sweep.spec.search);
  for (const auto& [check, interval] : summary.criteria) {
    const char* const verdict = !summary.is_complete ? "so far" : check.pass ? "pass" : "FAIL";
    text += fmt::format("  {}  {:<40} {:>10} {:<4} {}{}\n", verdict, check.name, sweeper::ValueText(check), check.unit,
                        check.limit, IntervalText(interval));
  }
  if (const std::string failed = sweeper::FailedProcesses(sweep.results); !failed.empty()) {
    text += fmt::format("  {}{}\n", failed, sweep.spec.search ? "" : "; --retry flies them again");
  }
  if (sweep.total > sweep.planned) {
    text += fmt::format("  {} more flights belong to parts of the sweep that are not collected here\n",
                        sweep.total - sweep.planned);
  }
  if (sweep.stale > 0) text += fmt::format("  {} rows of another build are kept, but not counted\n", sweep.stale);
  if (sweep.unplanned > 0) {
    text +=
        fmt::format("  {} rows from before a change of the sweep file are kept, but not counted\n", sweep.unplanned);
  }
  return text + fmt::format("rows in {0}/sweep.db, report in {0}/report.html\n", out);
}

std::string SummaryJson(const sweeper::SweepOutcome& sweep, const sweeper::SweepSummary& summary,
                        const std::string& out) {
  Json json{{"schema", kSchema}, {"version", util::Version()}, {"sweep", sweep.spec.name}, {"planned", sweep.total}};
  Put(summary.all, json);
  json["stale"] = sweep.stale;
  json["unplanned"] = sweep.unplanned;
  json["crashed"] = sweeper::CountEnds(sweep.results, sweeper::ProcessEnd::kCrashed);
  json["hung"] = sweeper::CountEnds(sweep.results, sweeper::ProcessEnd::kHung);
  json["out_of_memory"] = sweeper::CountEnds(sweep.results, sweeper::ProcessEnd::kOutOfMemory);
  // An incomplete sweep has no verdict.
  const bool passes = sweep.spec.search ? summary.finds_boundary() : summary.meets_criteria();
  json["pass"] = summary.is_complete ? Json(passes) : Json();
  json["parameters"] = Json::array();
  for (const sweeper::PassCountOf& each : summary.by_value) {
    Json value{{"key", each.key}, {"value", sweeper::ParameterJson(each.value)}};
    Put(each.count, value);
    json["parameters"].push_back(std::move(value));
  }
  json["edges"] = Json::array();
  for (const sweeper::PassBoundaryOf& each : summary.boundaries) {
    Json boundary{{"key", each.key}, {"variant", each.variant}, {"pass_rate", each.pass_rate}};
    if (each.boundary) Put(*each.boundary, boundary);
    boundary["may_lie_beyond"] = each.may_lie_beyond;
    json["edges"].push_back(std::move(boundary));
  }
  json["criteria"] = Json::array();
  for (const auto& [check, interval] : summary.criteria) {
    Json criterion{{"name", check.name}, {"unit", check.unit}, {"limit", check.limit}};
    criterion["pass"] = summary.is_complete ? Json(check.pass) : Json();
    if (interval) Put(*interval, criterion);
    if (!check.text.empty()) criterion["value"] = check.text;
    json["criteria"].push_back(std::move(criterion));
  }
  json["rows"] = out + "/sweep.db";
  json["report"] = out + "/report.html";
  return Dump(json);
}

}  // namespace touchdown::cli
