#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/output_options.h"
#include "scenarios/sweeper/analysis/compare.h"
#include "scenarios/util/number.h"

namespace touchdown::cli {
namespace {

struct CompareOptions {
  std::string a;
  std::optional<std::string> b;
  std::vector<std::string> variants;
  std::vector<std::string> margins;
  OutputOptions output;
};

/// Parses NAME=NUMBER, for example "pass_rate=0.02". Throws InputError.
sweeper::Margin MarginFrom(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
  const std::optional<double> value = util::FiniteNumber(number);
  if (!value || *value < 0.0) {
    throw InputError(fmt::format("--margin {}: must be NAME=NUMBER with a number of at least 0", text));
  }
  return {.name = text.substr(0, sign), .margin = *value};
}

/// The two sets of results to compare, and their names for the output.
struct Sides {
  sweeper::StoredResults a, b;
  std::string name_a, name_b;
};

Sides Load(const CompareOptions& options) {
  if (options.variants.empty()) {
    if (!options.b) throw InputError("give two sweeps, or one sweep and --variants");
    return {sweeper::LoadResults(options.a), sweeper::LoadResults(*options.b), options.a, *options.b};
  }
  if (options.b) throw InputError("--variants: compares two variants of one sweep, but two sweeps are given");
  const sweeper::StoredResults stored = sweeper::LoadResults(options.a);
  const std::string &a = options.variants.front(), &b = options.variants.back();
  return {sweeper::OfVariant(stored, a), sweeper::OfVariant(stored, b), a, b};
}

void Print(const sweeper::Comparison& comparison, const Sides& sides) {
  const sweeper::PairedDifference& all = comparison.differences.front();
  fmt::print("{} pairs of {} seeds; {} flights only in {}, {} only in {}\n", all.pairs, all.seeds, comparison.only_a,
             sides.name_a, comparison.only_b, sides.name_b);
  fmt::print("  {:<34} {:>6} {:>10} {:>10} {:>11}  {:<24} {:>10}\n", "", "pairs", "A", "B", "B - A", "95 %",
             "detectable");
  for (const sweeper::PairedDifference& d : comparison.differences) {
    fmt::print("{} {:<34} {:>6} {:>10.4g} {:>10.4g} {:>+11.4g}  {:<24} {:>10.3g} {}\n", d.is_worse ? "!" : " ", d.name,
               d.pairs, d.a, d.b, d.difference.value,
               fmt::format("{:+.4g} to {:+.4g}", d.difference.low, d.difference.high), d.min_detectable_difference,
               d.unit);
  }
  for (const sweeper::PairedDifference& d : comparison.differences) {
    if (d.is_worse) {
      fmt::print("worse: {}, significantly, by {:.4g}{}{}, which exceeds the margin of {:g}\n", d.name,
                 std::abs(d.difference.value), d.unit.empty() ? "" : " ", d.unit, d.margin);
    }
    if (d.margin > 0.0 && d.min_detectable_difference > d.margin) {
      fmt::print("{}: these seeds can detect a difference of {:.3g}, not the margin of {:g}; fly more seeds\n", d.name,
                 d.min_detectable_difference, d.margin);
    }
  }
}

std::string ComparisonJson(const sweeper::Comparison& comparison) {
  nlohmann::ordered_json json{{"only_a", comparison.only_a},
                              {"only_b", comparison.only_b},
                              {"is_worse", comparison.is_worse()},
                              {"differences", nlohmann::ordered_json::array()}};
  for (const sweeper::PairedDifference& d : comparison.differences) {
    json["differences"].push_back({{"name", d.name},
                                   {"unit", d.unit},
                                   {"pairs", d.pairs},
                                   {"seeds", d.seeds},
                                   {"a", d.a},
                                   {"b", d.b},
                                   {"difference", d.difference.value},
                                   {"low", d.difference.low},
                                   {"high", d.difference.high},
                                   {"min_detectable_difference", d.min_detectable_difference},
                                   {"margin", d.margin},
                                   {"is_worse", d.is_worse}});
  }
  return json.dump(2) + "\n";
}

int CompareBoth(const CompareOptions& options) {
  std::vector<sweeper::Margin> margins;
  for (const std::string& text : options.margins) margins.push_back(MarginFrom(text));
  const Sides sides = Load(options);
  const sweeper::Comparison comparison = sweeper::Compare(sides.a, sides.b, margins);
  if (comparison.only_a > 0) {
    spdlog::warn("{} lacks {} flights of {}, which are not compared", sides.name_b, comparison.only_a, sides.name_a);
  }
  if (options.output.json) fmt::print("{}", ComparisonJson(comparison));
  if (options.output.ForPeople()) Print(comparison, sides);
  return comparison.is_worse() ? kFailed : kPassed;
}

}  // namespace

void AddCompare(CLI::App& app, Run& run) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *app.add_subcommand("compare", "Compare a sweep with an earlier one, flight by flight");
  command.add_option("A", options->a, "Earlier sweep: its output directory, or its rows as CSV")->required();
  command.add_option("B", options->b, "Later sweep, in the same form");
  command.add_option("--variants", options->variants, "Compare these two variants of A; replaces B")
      ->type_name("A B")
      ->expected(2);
  command
      .add_option("--margin", options->margins,
                  "How much worse B may be, for example pass_rate=0.02 or flight.touchdown_xy_error_m=0.005; may be "
                  "repeated")
      ->type_name("NAME=NUMBER")
      ->allow_extra_args(false);
  AddOutputOptions(command, options->output);
  command.callback([options, &run] { run = [options] { return CompareBoth(*options); }; });
}

}  // namespace touchdown::cli
