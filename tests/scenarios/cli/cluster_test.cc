// Sweeps on several machines: in shards, with stub Slurm tools, and on a real Slurm cluster.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/sweeper/plan/sweep_store.h"
#include "tests/support/program_fixture.h"
#include "tests/support/short_sweep.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using tests::ProgramRun;

/// Sets an environment variable, and restores it in the destructor.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~ScopedVariable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

class ClusterTest : public tests::ProgramFixture {
 protected:
  void PutSweep(int seeds, const std::string& more = "") { tests::WriteShortSweep(folder_, seeds, more); }
  std::string OutOf(const std::vector<std::string>& arguments) {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  }
  /// Flies the sweep on this machine into `folder`, and returns its rows as CSV.
  std::string LocalCsv(const std::string& folder) {
    OutOf({"sweep", "sweep.yaml", "--out", folder, "--csv", folder + ".csv", "--quiet"});
    return folder_.Content(folder + ".csv");
  }
  std::string CollectedCsv(std::vector<std::string> folders) {
    const std::string csv = folders.front() + ".csv";
    folders.insert(folders.begin(), {"collect", "--csv", csv});
    OutOf(folders);
    return folder_.Content(csv);
  }
  nlohmann::json Status(const std::string& folder) {
    return nlohmann::json::parse(OutOf({"status", folder, "--json"}));
  }
  std::size_t CountIn(const std::string& folder) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_ / folder), {}));
  }
};

TEST_F(ClusterTest, CollectedPartsHaveTheRowsOfTheWholeSweep) {
  PutSweep(
      2,
      "parameters: {camera.noise_sigma: [0, 3]}\nvariants: [{name: plain}, {name: turned, set: {start.yaw_deg: 5}}]\n");
  const std::string whole = LocalCsv("whole");
  for (const std::string part : {"1", "2", "3"}) {
    OutOf({"sweep", "sweep.yaml", "--out", "part" + part, "--shard", part + "/3", "--quiet"});
  }
  EXPECT_THAT(OutOf({"status", "part1"}), StartsWith("sweep: 3 of 3 flights of this part, 8 in the whole sweep\n"));
  folder_.Put("part2/pictures/0123.png", "PNG");
  const ProgramRun incomplete = Run({"collect", "all", "part1"});
  EXPECT_EQ(incomplete.status, 1) << "flights are missing";
  EXPECT_THAT(incomplete.out,
              AllOf(HasSubstr("sweep: 3 of 3 flights\n"), HasSubstr("report in all/report.html\n"),
                    HasSubstr("5 more flights belong to parts of the sweep that are not collected here\n")));
  EXPECT_EQ(CollectedCsv({"all", "part2", "part1", "part3"}), whole);
  EXPECT_EQ(CollectedCsv({"all", "part1"}), whole) << "collecting a part twice changes nothing";
  EXPECT_TRUE(fs::exists(folder_ / "all/pictures/0123.png"));
  EXPECT_THAT(folder_.Content("all/report.html"), HasSubstr("camera.noise_sigma"));
  EXPECT_EQ(Status("all").at("flown"), 8);
}

TEST_F(ClusterTest, CollectsIntoTheFolderOfAKilledCollect) {
  PutSweep(2);
  const std::string whole = LocalCsv("whole");
  for (const std::string part : {"1", "2"}) {
    OutOf({"sweep", "sweep.yaml", "--out", "part" + part, "--shard", part + "/2", "--quiet"});
  }
  folder_.Put("empty/sweep.db", "");
  fs::create_directories(folder_ / "planless");
  const sweeper::SweepStore planless(folder_ / "planless", sweeper::SweepStore::Access::kWrite);
  EXPECT_THAT(ErrorOf({"collect", "all", "part1", "planless"}), HasSubstr("planless: contains no plan of a sweep yet"));
  EXPECT_EQ(CollectedCsv({"empty", "part1", "part2"}), whole);
  EXPECT_EQ(CollectedCsv({"planless", "part1", "part2"}), whole);
  EXPECT_EQ(Status("planless").at("planned"), 2);
}

TEST_F(ClusterTest, RejectsPartsOfAnotherSweepOrBuild) {
  PutSweep(2);
  OutOf({"sweep", "sweep.yaml", "--out", "part1", "--shard", "1/2", "--quiet"});
  fs::copy_file(folder_ / "sweep.yaml", folder_ / "other.yaml");
  OutOf({"sweep", "other.yaml", "--out", "other", "--shard", "2/2", "--quiet"});
  fs::copy_file(TOUCHDOWN_PROGRAM, folder_ / "another_build");
  std::ofstream(folder_ / "another_build", std::ios::app) << "newer";
  ASSERT_EQ(tests::RunProgram(folder_ / "another_build",
                              {"sweep", "sweep.yaml", "--out", "built", "--shard", "2/2", "--quiet"}, folder_.path())
                .status,
            0);
  PutSweep(1, "parameters: {camera.noise_sigma: [3]}\n");
  OutOf({"sweep", "sweep.yaml", "--out", "noisy", "--quiet"});

  EXPECT_THAT(ErrorOf({"collect", "all", "part1", "other"}),
              HasSubstr("other: contains sweep other, but part1 contains sweep"));
  EXPECT_THAT(ErrorOf({"collect", "all", "part1", "built"}),
              HasSubstr("built: contains a sweep of another build than part1"));
  EXPECT_THAT(ErrorOf({"collect", "all", "part1", "noisy"}), HasSubstr("noisy: contains other flights than part1"));
  EXPECT_THAT(ErrorOf({"collect", "all", "part1", "none"}), HasSubstr("none/sweep.db: no such file"));
  EXPECT_THAT(ErrorOf({"collect", "all"}), HasSubstr("all/sweep.db: no such file"));
  EXPECT_THAT(ErrorOf({"status", "all"}), HasSubstr("all/sweep.db: no such file"));
  EXPECT_FALSE(fs::exists(folder_ / "all"));
}

/// Replaces the Slurm tools by stubs that answer and do nothing.
class StubSlurmTest : public ClusterTest {
 protected:
  StubSlurmTest() {
    PutTool("scontrol",
            "[ $1 = release ] && cat ../out/slurm/job.yaml >../released; echo 'MaxArraySize            = 3'");
    PutTool("sbatch", "echo \"$@\" >>../submitted; echo '7;here'");
    PutTool("squeue", "");
  }
  void PutTool(const std::string& name, const std::string& script) {
    fs::permissions(folder_.Put("tools/" + name, "#!/bin/sh\ncd $(dirname $0)\n" + script + "\n"),
                    fs::perms::owner_exec, fs::perm_options::add);
  }
  std::string Submit(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"sweep", "sweep.yaml", "--slurm", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return OutOf(arguments);
  }

  const ScopedVariable path_{"PATH", (folder_ / "tools").string() + ":" + getenv("PATH")};
};

TEST_F(StubSlurmTest, SubmitsTasksWithinTheLimitsOfTheSite) {
  PutSweep(7);
  EXPECT_EQ(Submit({"--dry-run"}), "7 flights in 1 task\n") << "one task, because they take less than a few minutes";
  EXPECT_EQ(Submit({"--chunk", "1", "--dry-run"}), "7 flights in 3 tasks\n") << "the site allows three tasks";
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(Submit({"--chunk", "3", "--partition", "fast", "--account", "us", "--time", "10"}),
            "Slurm job 7: 7 flights in 3 tasks\n");
  EXPECT_THAT(folder_.Content("submitted"), AllOf(HasSubstr("--partition=fast --account=us --time=10 out/slurm.sh"),
                                                  HasSubstr("--chdir=" + (folder_ / "out").string())));
  EXPECT_THAT(folder_.Content("submitted"), HasSubstr("--hold"));
  EXPECT_EQ(folder_.Content("released"), "slurm_job: 7\n") << "released after the job id was written";
  EXPECT_THAT(folder_.Content("out/slurm.sh"), AllOf(HasSubstr("--array=0-2\n"), HasSubstr("--requeue\n")));
  EXPECT_EQ(CountIn("out/tasks"), 3u);
}

TEST_F(StubSlurmTest, SubmitsOnlyMissingFlights) {
  PutSweep(4);
  Submit({"--chunk", "2"});
  EXPECT_THAT(OutOf({"sweep-task", "out", "1"}), HasSubstr(" pass in "));
  EXPECT_EQ(OutOf({"sweep-task", "out", "1"}), "") << "all flights of the task are flown";
  PutTool("squeue", "echo RUNNING; echo PENDING; echo PENDING");
  EXPECT_EQ(OutOf({"status", "out"}),
            "sweep: 2 of 4 flights\n  passed 2\n  failed 0\nSlurm job 7: tasks: 2 PENDING, 1 RUNNING\n");
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--slurm", "--out", "out"}), HasSubstr("its Slurm job 7 has not ended"));
  PutTool("squeue", "");
  EXPECT_THAT(Run({"collect", "out"}).out, HasSubstr("2 of 4 flights\n"));
  EXPECT_EQ(CountIn("out/rows"), 0u);
  EXPECT_EQ(Status("out").at("flown"), 2);
  EXPECT_THAT(Submit({"--chunk", "1"}), HasSubstr("2 flights in 2 tasks"));
  EXPECT_EQ(CountIn("out/tasks"), 2u);
  OutOf({"sweep-task", "out", "0"});
  OutOf({"sweep-task", "out", "1"});
  EXPECT_EQ(Submit(), "sweep: all 4 flights are flown, nothing was submitted\n");
  EXPECT_EQ(CollectedCsv({"out"}), LocalCsv("here"));
}

TEST_F(StubSlurmTest, KeepsADamagedRowAndFliesTheFlightAgain) {
  PutSweep(1);
  Submit();
  const std::string id = nlohmann::json::parse(folder_.Content("out/tasks/0.json")).at("flights").at(0).at("id");
  folder_.Put("out/rows/" + id + ".json", "half a row");
  EXPECT_THAT(OutOf({"sweep-task", "out", "0"}), HasSubstr(id + " pass in "));
  EXPECT_EQ(folder_.Content("out/rows/" + id + ".damaged"), "half a row");
  EXPECT_EQ(Status("out").at("flown"), 1);
}

TEST_F(StubSlurmTest, CountsCrashedProcessesAndRetriesThem) {
  PutSweep(2);
  Submit();
  {
    sweeper::SweepStore store(folder_ / "out", sweeper::SweepStore::Access::kWrite);
    for (const sweeper::PlannedFlight& flight : store.Plan().flights)
      store.Put({.id = flight.id, .program = store.program()});
  }
  EXPECT_THAT(OutOf({"status", "out"}), StartsWith("sweep: 2 of 2 flights\n  passed 0\n  failed 2 (2 crashed)\nSlurm"));
  EXPECT_EQ(Status("out").at("processes").at("crashed"), 2);
  EXPECT_EQ(Submit({"--retry", "--chunk", "1"}), "Slurm job 7: 2 flights in 2 tasks\n");
  OutOf({"sweep-task", "out", "0"});
  EXPECT_THAT(OutOf({"status", "out"}), HasSubstr("  passed 1\n  failed 1 (1 crashed)\n"));
  EXPECT_EQ(Submit({"--retry"}), "Slurm job 7: 1 flights in 1 task\n");
}

TEST_F(StubSlurmTest, KeepsARowThatIsBeingWritten) {
  PutSweep(1);
  Submit();
  folder_.Put("out/rows/.0123.json.partial-1", "{");
  const fs::path old = folder_.Put("out/rows/.4567.json.partial-1", "{");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_THAT(Run({"collect", "out"}).out, HasSubstr("0 of 1 flights\n"));
  EXPECT_TRUE(fs::exists(folder_ / "out/rows/.0123.json.partial-1"));
  EXPECT_FALSE(fs::exists(old));
}

TEST_F(StubSlurmTest, ReportsWhyItCannotSubmit) {
  PutSweep(2);
  const std::vector<std::string> submit{"sweep", "sweep.yaml", "--slurm", "--out", "out"};
  PutTool("sbatch", "echo 'sbatch: error: no such partition\nsbatch: error: failed' >&2; exit 1");
  EXPECT_THAT(ErrorOf(submit), HasSubstr("sbatch failed: sbatch: error: no such partition; sbatch: error: failed"));
  fs::remove_all(folder_ / "out");
  PutSweep(2, "stop_when: {good_pass_rate: 0.9, bad_pass_rate: 0.5}\n");
  EXPECT_THAT(ErrorOf(submit), HasSubstr("a sweep with stop_when cannot be split"));
  PutSweep(2);
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--slurm"}), HasSubstr("--out"));
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--out", "out", "--chunk", "2"}), HasSubstr("--slurm"));
  EXPECT_THAT(ErrorOf({"sweep-task", "out", "0"}), HasSubstr("out/tasks/0.json: cannot be read: No such file"));
  const ScopedVariable no_tools("PATH", "/nowhere");
  EXPECT_THAT(ErrorOf(submit), HasSubstr("scontrol not found on this machine"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(StubSlurmTest, ReportsAJobThatItCannotRecordOrRelease) {
  PutSweep(2);
  const std::vector<std::string> submit{"sweep", "sweep.yaml", "--slurm", "--out", "out"};
  PutTool("sbatch", "mkdir ../out/slurm/job.yaml; echo 7");
  EXPECT_THAT(ErrorOf(submit), AllOf(HasSubstr("out/slurm/job.yaml"), HasSubstr("cancel it with scancel 7")));
  EXPECT_FALSE(fs::exists(folder_ / "released"));
  fs::remove(folder_ / "out/slurm/job.yaml");
  PutTool("sbatch", "echo 7");
  PutTool("scontrol", "[ $1 = show ] && echo 'MaxArraySize = 3' && exit; echo 'no connection' >&2; exit 1");
  EXPECT_THAT(ErrorOf(submit), AllOf(HasSubstr("scontrol failed: no connection"), HasSubstr("scontrol release 7")));
  EXPECT_EQ(folder_.Content("out/slurm/job.yaml"), "slurm_job: 7\n");
}

TEST_F(StubSlurmTest, RejectsTasksThatAnotherBuildPlanned) {
  PutSweep(1);
  Submit();
  nlohmann::json chunk = nlohmann::json::parse(folder_.Content("out/tasks/0.json"));
  chunk["program"] = "0123";
  folder_.Put("out/tasks/0.json", chunk.dump());
  EXPECT_THAT(ErrorOf({"sweep-task", "out", "0"}), HasSubstr("planned by another build"));
  folder_.Put("out/tasks/0.json", "{}");
  EXPECT_THAT(ErrorOf({"sweep-task", "out", "0"}), HasSubstr("not a chunk file of a sweep"));
}

/// Starts a Slurm cluster of two nodes on the loopback interface.
class SlurmClusterTest : public ClusterTest {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "a Slurm cluster needs root";
    if (std::system("command -v slurmctld slurmd sbatch munged >/dev/null") != 0) {
      GTEST_SKIP() << "Slurm is not installed; on Debian: apt-get install slurmctld slurmd slurm-client munge";
    }
    ASSERT_EQ(Cluster("start").status, 0);
  }
  void TearDown() override {
    if (!IsSkipped()) Cluster("stop");
  }
  ProgramRun Cluster(const std::string& what, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{what, "cluster"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run =
        tests::RunProgram(TOUCHDOWN_SOURCE_DIR "/tests/support/slurm_cluster.sh", arguments, folder_.path());
    EXPECT_EQ(run.status, 0) << run.err;
    return run;
  }
  template <typename Condition>
  void WaitUntil(const Condition& condition) {
    const auto end = steady_clock::now() + std::chrono::minutes(4);
    while (!condition()) {
      ASSERT_LT(steady_clock::now(), end) << OutOf({"status", "out"}) << folder_.Content("cluster/slurmctld.log");
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
  }
  bool IsOver() {
    const nlohmann::json status = Status("out");
    return status.contains("slurm_tasks") && status.at("slurm_tasks").empty();
  }
  void Submit(int chunk) {
    PutSweep(12);
    EXPECT_EQ(OutOf({"sweep", "sweep.yaml", "--slurm", "--chunk", std::to_string(chunk), "--out", "out"}),
              "Slurm job 1: 12 flights in " + std::to_string(12 / chunk) + " tasks\n");
  }

  const ScopedVariable conf_{"SLURM_CONF", (folder_ / "cluster/slurm.conf").string()};
};

TEST_F(SlurmClusterTest, FliesTheSameRowsAsOneMachine) {
  Submit(2);
  WaitUntil([&] { return IsOver(); });
  EXPECT_EQ(Status("out").at("flown"), 12) << folder_.Content("out/slurm/0.log");
  EXPECT_EQ(CollectedCsv({"out"}), LocalCsv("here"));
  EXPECT_THAT(ErrorOf({"sweep", "sweep.yaml", "--slurm", "--out", "new", "--partition", "none"}),
              HasSubstr("invalid partition specified: none"));
}

TEST_F(SlurmClusterTest, FliesTheSameRowsAfterANodeFailure) {
  Submit(4);
  WaitUntil([&] { return fs::exists(folder_ / "out/rows") && CountIn("out/rows") > 0; });
  Cluster("kill-node", {"n1"});
  Run({"collect", "out"});  // While the sweep runs; a row that is flown twice is replaced by an identical one.
  WaitUntil([&] { return IsOver(); });
  EXPECT_EQ(std::system("scontrol show job | grep -q Restarts=1"), 0) << "one task is restarted";
  EXPECT_EQ(Status("out").at("flown"), 12);
  EXPECT_EQ(CollectedCsv({"out"}), LocalCsv("here"));
}

}  // namespace
}  // namespace touchdown::cli
