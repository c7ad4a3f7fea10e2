#include "scenarios/sweeper/run/process_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <thread>

#include "models/error.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::sweeper {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Replaces a flight; the id selects the behavior.
void FlySubstitute(const FlightTask& task, const RowFolder& folder) {
  const auto is = [&task](const char* what) { return task.id.find(what) != std::string::npos; };
  std::cerr << task.id << " flies\n";
  if (is("crash")) raise(SIGABRT);
  if (is("memory")) raise(SIGKILL);
  if (is("alloc")) throw std::bad_alloc();
  if (is("cv_nomem")) throw cv::Exception(cv::Error::StsNoMem, "no memory", "", "", 0);
  if (is("opencv")) throw cv::Exception(cv::Error::StsAssert, "at fault", "", "", 0);
  if (is("hang")) std::this_thread::sleep_for(std::chrono::seconds(100));
  if (is("silent")) return;
  if (is("status")) _exit(4);
  if (is("fault")) throw std::runtime_error("at fault");
  if (is("full")) throw InputError("output file rows/full.json: cannot be written");
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  folder.Write({.id = task.id,
                .process = ProcessEnd::kFlown,
                .verdict = runner::Verdict::kPass,
                .outcome = runner::Outcome::kLanded,
                .scenario = task.scenario_yaml});
}

class ProcessPoolTest : public testing::Test {
 protected:
  /// Flies tasks with these ids and stores their rows in `rows_`.
  void Fly(const std::vector<std::string>& ids, int jobs, const util::StopRequested& stop = nullptr) {
    std::vector<FlightTask> tasks;
    for (const std::string& id : ids) tasks.push_back({id, "scenario of " + id, 2.0, 0});
    std::size_t next = 0;
    const RowFolder rows(folder_.path());
    FlyTasks(
        rows, {.jobs = jobs, .fly = [&](const FlightTask& task) { FlySubstitute(task, rows); }},
        [&] { return next < tasks.size() ? &tasks[next++] : nullptr; },
        [&](const FlightRow& row) { rows_[row.id] = row; }, stop);
  }

  const tests::TemporaryFolder folder_;
  std::map<std::string, FlightRow> rows_;
};

TEST_F(ProcessPoolTest, ReturnsARowOfEachFlight) {
  Fly({"a", "b", "c", "d", "e"}, 2);
  ASSERT_EQ(rows_.size(), 5u);
  for (const auto& [id, row] : rows_) {
    EXPECT_TRUE(row.passed()) << id;
    EXPECT_EQ(row.stderr_tail, id + " flies\n");
  }
}

TEST_F(ProcessPoolTest, ContinuesAndReportsFailedProcesses) {
  Fly({"crash", "a", "memory", "silent", "status", "fault", "b"}, 2);
  ASSERT_EQ(rows_.size(), 7u);
  EXPECT_TRUE(rows_["a"].passed());
  EXPECT_TRUE(rows_["b"].passed());
  EXPECT_EQ(rows_["crash"].process, ProcessEnd::kCrashed);
  EXPECT_THAT(rows_["crash"].reason, HasSubstr("Aborted"));
  EXPECT_EQ(rows_["crash"].stderr_tail, "crash flies\n");
  EXPECT_EQ(rows_["crash"].scenario, "scenario of crash");
  EXPECT_EQ(rows_["memory"].process, ProcessEnd::kOutOfMemory);
  EXPECT_EQ(rows_["silent"].process, ProcessEnd::kCrashed);
  EXPECT_THAT(rows_["status"].reason, HasSubstr("status 4"));
  EXPECT_THAT(rows_["fault"].stderr_tail, HasSubstr("internal error: at fault"));
  for (const char* id : {"crash", "memory", "silent", "status", "fault"}) {
    EXPECT_EQ(rows_[id].verdict, runner::Verdict::kError);
    EXPECT_TRUE(fs::exists(folder_ / "rows" / (std::string(id) + ".json"))) << "written as a file";
  }
}

TEST_F(ProcessPoolTest, DistinguishesLackOfMemoryFromOtherErrors) {
  Fly({"alloc", "cv_nomem", "opencv"}, 2);
  EXPECT_EQ(rows_["alloc"].process, ProcessEnd::kOutOfMemory);
  EXPECT_EQ(rows_["cv_nomem"].process, ProcessEnd::kOutOfMemory);
  EXPECT_EQ(rows_["cv_nomem"].reason, "exceeded the memory limit");
  EXPECT_EQ(rows_["opencv"].process, ProcessEnd::kCrashed);
}

TEST_F(ProcessPoolTest, KillsHungProcesses) {
  const auto begin = std::chrono::steady_clock::now();
  Fly({"hang", "a", "b"}, 2);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(rows_["hang"].process, ProcessEnd::kHung);
  EXPECT_EQ(rows_["hang"].reason, "exceeded the time limit of 2 s");
  EXPECT_TRUE(rows_["b"].passed());
}

TEST_F(ProcessPoolTest, CompletesRunningFlightsAfterAStopRequest) {
  int calls = 0;
  Fly({"a", "b", "c", "d"}, 2, [&] { return ++calls > 2; });
  EXPECT_EQ(rows_.size(), 2u);
}

TEST_F(ProcessPoolTest, ThrowsIfRowsCannotBeWritten) {
  try {
    Fly({"a", "full", "b"}, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), std::string("output file rows/full.json: cannot be written"));
  }
  EXPECT_EQ(rows_.size(), 1u);
}

}  // namespace
}  // namespace touchdown::sweeper
