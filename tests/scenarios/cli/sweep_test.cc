// `touchdown sweep`, run as a program: interrupted, killed, with a full disk, with crashed flights.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "models/error.h"
#include "scenarios/sweeper/plan/sweep_store.h"
#include "scenarios/sweeper/run/run_sweep.h"
#include "tests/support/program_fixture.h"
#include "tests/support/short_sweep.h"
#include "tests/support/small_mount.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using tests::ProgramRun;
using tests::SmallMount;

class SweepCommand : public tests::ProgramFixture {
 protected:
  void PutSweep(int seeds, const std::string& more = "") { tests::WriteShortSweep(folder_, seeds, more); }
  ProgramRun Sweep(const std::vector<std::string>& more = {}, const tests::Interruption& interruption = {}) {
    std::vector<std::string> arguments{"sweep", "sweep.yaml", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments, interruption);
  }
  /// Completes the sweep in `folder`, and returns its rows as CSV.
  std::string Csv(const std::string& folder) {
    EXPECT_EQ(Run({"sweep", "sweep.yaml", "--out", folder, "--csv", folder + ".csv", "--quiet"}).status, 0);
    return folder_.Content(folder + ".csv");
  }
  /// Wall-clock time of each row. It differs when a flight is flown again.
  std::string WallTimes(const std::string& folder) const {
    std::string walls;
    for (const sweeper::SweepResult& result :
         sweeper::SweepStore(folder_ / folder, sweeper::SweepStore::Access::kRead).Results()) {
      walls += std::to_string(result.row.wall_s) + "\n";
    }
    return walls;
  }
  /// Wall-clock time of each row by id; empty while the sweep does not exist.
  std::map<std::string, double> KeptRows(const std::string& folder) const {
    std::map<std::string, double> kept;
    try {
      for (const sweeper::FlightRow& row : sweeper::UncollectedRows(folder_ / folder)) kept[row.id] = row.wall_s;
      for (const sweeper::SweepResult& result :
           sweeper::SweepStore(folder_ / folder, sweeper::SweepStore::Access::kRead).Results()) {
        kept[result.row.id] = result.row.wall_s;
      }
    } catch (const InputError&) {
    }
    return kept;
  }
  /// Sends a signal to a flight process of the sweep. Returns false if there is none.
  bool Signal(int signal) const {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream stream(entry.path() / "comm");
      std::string name;
      if (!(stream >> name) || name != "touchdown-fly") continue;
      std::error_code error;
      if (fs::read_symlink(entry.path() / "cwd", error) != fs::canonical(folder_.path()) || error) continue;
      return kill(std::stoi(entry.path().filename().string()), signal) == 0;
    }
    return false;
  }
};

TEST_F(SweepCommand, FliesEachFlightOnceForAnyNumberOfJobs) {
  PutSweep(3, "parameters: {camera.noise_sigma: [0, 3]}\n");
  const ProgramRun run = Sweep({"--jobs", "2", "--csv", "two.csv"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("sweep: 6 of 6 flights"), HasSubstr("camera.noise_sigma=3"), HasSubstr("100.0 %")));
  ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", "one", "--jobs", "1", "--csv", "one.csv"}).status, 0);
  const std::string csv = folder_.Content("two.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  EXPECT_EQ(csv, folder_.Content("one.csv"));

  const std::string walls = WallTimes("out");
  EXPECT_EQ(Csv("out"), csv);
  EXPECT_EQ(WallTimes("out"), walls) << "nothing was flown again";
  PutSweep(4, "parameters: {camera.noise_sigma: [0, 3]}\n");
  const std::string longer = Csv("out");
  EXPECT_EQ(std::count(longer.begin(), longer.end(), '\n'), 9) << "two more rows";
  PutSweep(4, "parameters: {camera.noise_sigma: [0]}\n");
  EXPECT_THAT(Sweep().out,
              AllOf(HasSubstr("4 of 4 flights"), HasSubstr("4 rows from before a change of the sweep file")));
}

TEST_F(SweepCommand, ListsTheFlightsWithoutFlying) {
  PutSweep(2, "parameters: {camera.noise_sigma: [0, 3]}\n");
  const ProgramRun run = Run({"sweep", "sweep.yaml", "--dry-run"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("seed 2  camera.noise_sigma=3\n"), HasSubstr("4 flights; ")));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(SweepCommand, DryRunEstimatesTheRemainingTimeFromFlownRows) {
  PutSweep(1);
  ASSERT_EQ(Sweep({"--quiet"}).status, 0);
  PutSweep(3);
  EXPECT_THAT(Sweep({"--dry-run"}).out,
              AllOf(HasSubstr("3 flights, 1 of them flown; "), HasSubstr("at the speed of the flown ones")));
  const auto json = nlohmann::json::parse(Sweep({"--dry-run", "--jobs", "1", "--json"}).out);
  EXPECT_EQ(json.at("planned"), 3);
  EXPECT_EQ(json.at("flown"), 1);
  EXPECT_EQ(json.at("flights").at(2).at("seed"), 3);
  EXPECT_NEAR(json.at("expected_s").get<double>(), 2.0 * std::stod(WallTimes("out")), 1e-4);
}

TEST_F(SweepCommand, ReproducesTheLogOfARow) {
  PutSweep(1);
  const std::string csv = Csv("out");
  const std::string id = csv.substr(csv.find('\n') + 1, 16), hash = csv.substr(csv.size() - 65, 64);
  const ProgramRun run = Run({"fly", "--from", "out", id, "--out", "again", "--video", "off"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("differs from the sweep's")));
  EXPECT_EQ(nlohmann::json::parse(folder_.Content("again/result.json")).at("log_sha256"), hash);
  EXPECT_THAT(ErrorOf({"fly", "--from", "out", "0123"}), HasSubstr("out: contains no flight 0123"));
  EXPECT_THAT(ErrorOf({"fly", "--from", "none", id}), HasSubstr("none/sweep.db: no such file"));
  EXPECT_THAT(ErrorOf({"fly"}), HasSubstr("--from DIR ID"));
}

TEST_F(SweepCommand, FailsWhenItsCriteriaAreNotMet) {
  PutSweep(2, "criteria: [{metric: pass_rate, min: 0.5}, {metric: flight.sim_time_s, quantile: 0.5, max: 0.01}]\n");
  const ProgramRun run = Sweep();
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("pass  pass_rate"), HasSubstr("FAIL  flight.sim_time_s at 0.5")));

  const auto json = nlohmann::json::parse(Sweep({"--json"}).out);
  EXPECT_EQ(json.at("passed"), 2);
  EXPECT_NEAR(json.at("pass_rate").at("low").get<double>(), 0.3424, 1e-4) << "Wilson's of 2 in 2";
  EXPECT_EQ(json.at("pass"), false);
  EXPECT_EQ(json.at("criteria").at(0).at("pass"), true);
  EXPECT_EQ(json.at("criteria").at(1).at("pass"), false);
  EXPECT_TRUE(json.at("criteria").at(1).at("high").is_null()) << "two flights bound no median";
}

TEST_F(SweepCommand, RebuildsTheReportFromItsRowsAlone) {
  PutSweep(2, "criteria: [{metric: flight.sim_time_s, quantile: 0.5, max: 0.01}]\n");
  ASSERT_EQ(Sweep().status, 1);
  const std::string page = folder_.Content("out/report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("Criteria not met"), HasSubstr("flight.sim_time_s at 0.5")));
  for (const char* name : {"sweep.yaml", "short.yaml", "out/report.html"}) fs::remove(folder_ / name);
  EXPECT_EQ(Run({"report", "out"}).status, 0);
  EXPECT_EQ(folder_.Content("out/report.html"), page);

  folder_.Put("out/report.html", "mine");
  EXPECT_THAT(ErrorOf({"report", "out"}), HasSubstr("out/report.html: already exists and is not an earlier output"));
  PutSweep(3);
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "out"}), HasSubstr("out/report.html"));
  EXPECT_EQ(folder_.Content("out/report.html"), "mine");
}

TEST_F(SweepCommand, StopsEarlyWithTheSameRowsForAnyNumberOfJobs) {
  PutSweep(30, "stop_when: {good_pass_rate: 0.9, bad_pass_rate: 0.5, good_refused: 0.1, bad_accepted: 0.1}\n");
  // Each pass adds ln(0.5/0.9) to the log-likelihood ratio, so four of them reach ln(0.1/0.9).
  EXPECT_THAT(Sweep({"--jobs", "2", "--csv", "two.csv"}).out, HasSubstr("4 of 4 flights"));
  ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", "one", "--jobs", "1", "--csv", "one.csv"}).status, 0);
  EXPECT_EQ(folder_.Content("two.csv"), folder_.Content("one.csv"));
}

TEST_F(SweepCommand, FindsTheBoundaryAtWhichFlightsBeginToFail) {
  // A flight takes 0.115 s longer than its hover, so it exceeds the limit when the hover exceeds 0.15 s.
  PutSweep(1,
           "set: {criteria: [{metric: flight.sim_time_s, max: 0.265}]}\n"
           "parameters: {script.0.duration_s: {range: {from: 0.05, to: 0.25, count: 2}}}\n");
  const std::vector<std::string> search{"sweep",     "sweep.yaml", "--boundary", "script.0.duration_s",
                                        "--flights", "24",         "--out",      "edge"};
  const ProgramRun run = Run(search);
  EXPECT_EQ(run.status, 0) << run.err;
  double edge = 0.0, low = 0.0, high = 0.0;
  const std::size_t at = run.out.find("script.0.duration_s = ");
  ASSERT_NE(at, std::string::npos) << run.out;
  ASSERT_EQ(std::sscanf(run.out.c_str() + at, "script.0.duration_s = %lf (95 %%: %lf to %lf)", &edge, &low, &high), 3);
  EXPECT_NEAR(edge, 0.15, 0.01);
  EXPECT_LE(low, 0.15);
  EXPECT_GE(high, 0.15);
  EXPECT_THAT(folder_.Content("edge/report.html"), HasSubstr("boundary at a pass rate of 50 %"));
  const std::string walls = WallTimes("edge");
  EXPECT_EQ(Run(search).out, run.out);
  EXPECT_EQ(WallTimes("edge"), walls) << "nothing was flown again";
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--boundary", "camera.noise_sigma", "--out", "edge"}),
              HasSubstr("--boundary camera.noise_sigma: must be a parameter with listed values"));

  PutSweep(1, "parameters: {script.0.duration_s: {range: {from: 0.05, to: 0.25, count: 2}}}\n");
  const ProgramRun alike =
      Run({"sweep", "sweep.yaml", "--boundary", "script.0.duration_s", "--flights", "6", "--out", "alike"});
  EXPECT_EQ(alike.status, 1) << alike.err;
  EXPECT_THAT(alike.out, HasSubstr("no value of script.0.duration_s from 0.05 to 0.25 found at which 50 % pass"));
  const auto json = nlohmann::json::parse(
      Run({"sweep", "sweep.yaml", "--boundary", "script.0.duration_s", "--flights", "6", "--out", "alike", "--json"})
          .out);
  EXPECT_EQ(json.at("pass"), false);
  EXPECT_FALSE(json.at("edges").at(0).contains("value"));
  PutSweep(1,
           "parameters: {script.0.duration_s: [0.1, 0.2]}\n"
           "variants: [{name: a}, {name: b, set: {start.yaw_deg: 5}}]\n");
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--boundary", "script.0.duration_s", "--out", "two"}),
              HasSubstr("not allowed for sweep sweep, which has variants"));
}

TEST_F(SweepCommand, ResumesAfterAnInterrupt) {
  PutSweep(8);
  const ProgramRun run = Sweep({"--jobs", "2"}, {SIGINT, [&] { return Signal(0); }});
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the same command resumes from there"));
  EXPECT_THAT(run.out, Not(HasSubstr("8 of 8")));
  EXPECT_THAT(folder_.Content("out/report.html"), HasSubstr("of 8 flights have not been"));
  EXPECT_THAT(Sweep().out, HasSubstr("8 of 8 flights"));
  EXPECT_THAT(folder_.Content("out/report.html"), Not(HasSubstr("have not been flown")));
}

TEST_F(SweepCommand, HasTheSameRowsAfterTwentyKills) {
  PutSweep(60);
  const std::string undisturbed = Csv("undisturbed");
  std::mt19937 random(1);
  int killed = 0;
  for (int i = 0; i < 20; ++i) {
    const auto end = steady_clock::now() + std::chrono::milliseconds(std::uniform_int_distribution(100, 1500)(random));
    killed += Sweep({"--quiet"}, {SIGKILL, [&] { return steady_clock::now() > end; }}).status == -1 ? 1 : 0;
  }
  EXPECT_GT(killed, 10);
  EXPECT_EQ(Csv("out"), undisturbed);
}

TEST_F(SweepCommand, RejectsASecondSweepInTheSameFolder) {
  PutSweep(6);
  ProgramRun second;
  Sweep({"--jobs", "1"}, {SIGINT, [&] {
                            if (!Signal(0)) return false;
                            second = Run({"sweep", "sweep.yaml", "--out", "out"});
                            return true;
                          }});
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.err, HasSubstr("output folder out: is in use by another sweep"));
}

TEST_F(SweepCommand, ReportsFlightsWhoseProcessCrashedOrHung) {
  PutSweep(3, "limits: {wall_s: 4}\n");
  bool crashed = false;
  const ProgramRun run =
      Sweep({"--jobs", "1", "--csv", "rows.csv"}, {SIGCONT, [&] { return crashed = Signal(SIGSEGV); }});
  EXPECT_TRUE(crashed);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 of 3 flights"));
  EXPECT_THAT(folder_.Content("rows.csv"), HasSubstr(",crashed,error,"));
  EXPECT_THAT(Sweep().out, AllOf(HasSubstr("2 of 3;"), HasSubstr("1 crashed; --retry flies them again")))
      << "a crash is a result, and is not flown again";
  EXPECT_THAT(Sweep({"--retry", "--csv", "rows.csv"}).out, HasSubstr("3 of 3;"));
  EXPECT_THAT(folder_.Content("rows.csv"), Not(HasSubstr(",error,")));
  ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", "hung", "--jobs", "1", "--csv", "hung.csv"},
                {SIGCONT, [&] { return Signal(SIGSTOP); }})
                .status,
            0);
  EXPECT_THAT(folder_.Content("hung.csv"), HasSubstr(",hung,error,"));
}

TEST_F(SweepCommand, ReportsAFlightThatNeedsTooMuchMemory) {
  for (const std::string limit : {"256", "400", "500"}) {
    PutSweep(1, "limits: {memory_mb: " + limit + "}\n");
    ASSERT_EQ(Run({"sweep", "sweep.yaml", "--out", limit, "--csv", limit + ".csv"}).status, 0);
    EXPECT_THAT(folder_.Content(limit + ".csv"), HasSubstr(",out_of_memory,error,"));
    const sweeper::SweepResult result =
        sweeper::SweepStore(folder_ / limit, sweeper::SweepStore::Access::kRead).Results().at(0);
    EXPECT_EQ(result.row.process, sweeper::ProcessEnd::kOutOfMemory) << limit << " MB: " << result.row.reason;
    EXPECT_EQ(result.row.verdict, runner::Verdict::kError);
  }
}

TEST_F(SweepCommand, KeepsItsRowsWhenTheDiskIsFullOrReadOnly) {
  PutSweep(6);
  fs::create_directories(folder_ / "small");
  const SmallMount small(folder_ / "small");
  if (!small.is_mounted()) GTEST_SKIP() << "no permission to mount";
  const std::vector<std::string> sweep{"sweep", "sweep.yaml", "--out", "small/out", "--jobs", "1"};
  // The disk becomes full during the sweep, after some rows are written.
  std::map<std::string, double> before;
  const ProgramRun filled = Run(sweep, {SIGCONT, [&] {
                                          before = KeptRows("small/out");
                                          if (before.size() < 2) return false;
                                          small.Fill();
                                          return true;
                                        }});
  EXPECT_EQ(filled.status, 2) << filled.out << filled.err;
  EXPECT_THAT(filled.err, HasSubstr("small/out"));
  const std::map<std::string, double> kept = KeptRows("small/out");
  EXPECT_GE(before.size(), 2u);
  EXPECT_THAT(kept, IsSupersetOf(before));
  EXPECT_LT(kept.size(), 6u);
  small.MakeReadOnly();
  EXPECT_THAT(ErrorOf(sweep), HasSubstr("small/out"));
  EXPECT_EQ(KeptRows("small/out"), kept);
  small.FreeSpace();
  EXPECT_EQ(Csv("small/out"), Csv("elsewhere")) << "it resumes once there is space";
  EXPECT_THAT(KeptRows("small/out"), IsSupersetOf(kept)) << "kept rows are not flown again";
}

TEST_F(SweepCommand, RejectsBadInputAndWritesNothing) {
  PutSweep(2, "parameters: {camera.noise_sigm: [1]}\n");
  const std::set<std::string> before = Names();
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "out"}),
              HasSubstr("sweep.yaml:3: camera.noise_sigm: unknown key"));
  PutSweep(2, "description: caf\xe9\n");
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "out"}), HasSubstr("sweep.yaml:3: is not UTF-8"));
  EXPECT_THAT(ErrorOf({"sweep", "none.yaml", "--out", "out"}), HasSubstr("none.yaml"));
  PutSweep(2);
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml"}), HasSubstr("--out"));
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "out", "--shard", "3/2"}), HasSubstr("--shard 3/2"));
  EXPECT_EQ(Names(), before);
  folder_.Put("full/letter.txt", "mine");
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "full"}),
              HasSubstr("output folder full: is not empty and contains no sweep"));
  folder_.Put("other/sweep.db", "mine");
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "other"}), HasSubstr("other/sweep.db: file is not a database"));
  EXPECT_EQ(folder_.Content("other/sweep.db"), "mine");
}

}  // namespace
}  // namespace touchdown::cli
