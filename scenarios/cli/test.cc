#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/interrupt.h"
#include "scenarios/report/junit.h"
#include "scenarios/sweeper/run/flight_suite.h"
#include "scenarios/util/output_file.h"

namespace touchdown::cli {
namespace {

struct TestOptions {
  std::string folder;
  std::optional<std::string> junit;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

void PrintTestedFlight(const sweeper::TestedFlight& test) {
  fmt::print("{:<5} {:<32} {:6.1f} s  {} ({})\n", test.row.passed() ? "pass" : "FAIL", test.file.stem().string(),
             test.row.wall_s, Name(test.row.outcome), test.row.reason);
  for (const runner::Check& check : test.checks) {
    if (check.pass) continue;
    const std::string value = check.value          ? fmt::format("{:.4g} {}", *check.value, check.unit)
                              : check.text.empty() ? "none"
                                                   : check.text;
    fmt::print("      {} is {}, must be {}\n", check.name, value, check.limit);
  }
  if (!test.row.passed()) fmt::print("      touchdown fly {}\n", test.file.string());
  std::fflush(stdout);
}

std::string Junit(const std::vector<sweeper::TestedFlight>& tests) {
  std::vector<report::JunitSuite> suites;
  for (const sweeper::TestedFlight& test : tests) {
    suites.push_back(report::SuiteOf(test.scenario, test.row.verdict, test.row.reason, test.row.metrics, test.checks));
  }
  return report::JunitXml(suites);
}

int Test(const TestOptions& options) {
  if (options.junit) util::CheckOutputFile(*options.junit, report::kJunitSignature);
  const std::vector<sweeper::TestedFlight> tests =
      sweeper::TestFlights(options.folder, options.jobs, InterruptRequested, PrintTestedFlight);
  if (options.junit) util::WriteOutputFile(*options.junit, Junit(tests), report::kJunitSignature);
  const auto passed =
      std::count_if(tests.begin(), tests.end(), [](const sweeper::TestedFlight& t) { return t.row.passed(); });
  fmt::print("{} of {} flights passed\n", passed, tests.size());
  const bool is_error = std::any_of(tests.begin(), tests.end(), [](const sweeper::TestedFlight& t) {
    return t.row.verdict == runner::Verdict::kError;
  });
  if (is_error) return kInternalError;
  return passed == static_cast<std::ptrdiff_t>(tests.size()) ? kPassed : kFailed;
}

}  // namespace

void AddTest(CLI::App& app, Run& run) {
  const auto options = std::make_shared<TestOptions>();
  CLI::App& command = *app.add_subcommand("test", "Fly every scenario of a directory as a test");
  command.add_option("FOLDER", options->folder, "Directory of the scenarios")->required();
  command.add_option("--jobs", options->jobs, "Maximum number of concurrent flights (default: the number of cores)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_option("--junit", options->junit, "Write all criteria to this JUnit XML file")->type_name("FILE");
  command.callback([options, &run] { run = [options] { return Test(*options); }; });
}

}  // namespace touchdown::cli
