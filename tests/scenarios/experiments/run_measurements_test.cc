#include "scenarios/experiments/run_measurements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "models/error.h"
#include "scenarios/util/platform.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::experiments {
namespace {

class RunMeasurementsTest : public testing::Test {
 protected:
  Measurement Counted(const std::string& id, double expected_s = 1.0) {
    return {.id = id, .expected_s = expected_s, .measure = [this, id](const util::StopRequested&) {
              ++runs_;
              return Json{{"of", id}};
            }};
  }
  MeasurementStore Store(const std::string& origin = "build 1") { return {folder_.path() / "measurements", origin}; }

  tests::TemporaryFolder folder_;
  std::atomic<int> runs_ = 0;
};

TEST_F(RunMeasurementsTest, RunsAllAndReportsProgress) {
  std::vector<double> fractions;
  const Measured measured =
      RunMeasurements({Counted("a"), Counted("b", 5.0), Counted("c")}, Store(), 2, nullptr,
                      [&](double fraction, const std::string&) { fractions.push_back(fraction); });
  ASSERT_EQ(measured.size(), 3u);
  EXPECT_EQ(measured.at("b").at("of"), "b");
  ASSERT_EQ(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_DOUBLE_EQ(fractions.back(), 1.0);
}

TEST_F(RunMeasurementsTest, ResumesAfterAnInterrupt) {
  std::vector<Measurement> measurements{Counted("a"), Counted("b"), Counted("c")};
  const auto stop = [this] { return runs_ >= 2; };
  EXPECT_THROW(RunMeasurements(measurements, Store(), 1, stop, nullptr), util::Interrupted);
  EXPECT_EQ(runs_, 2);
  EXPECT_EQ(RunMeasurements(measurements, Store(), 1, nullptr, nullptr).size(), 3u);
  EXPECT_EQ(runs_, 3);
}

TEST_F(RunMeasurementsTest, RepeatsMeasurementsOfAnotherBuild) {
  RunMeasurements({Counted("a")}, Store("build 1"), 1, nullptr, nullptr);
  RunMeasurements({Counted("a")}, Store("build 1"), 1, nullptr, nullptr);
  EXPECT_EQ(runs_, 1);
  RunMeasurements({Counted("a")}, Store("build 2"), 1, nullptr, nullptr);
  EXPECT_EQ(runs_, 2);
}

TEST_F(RunMeasurementsTest, StoresThePlatformOfAMeasurement) {
  EXPECT_TRUE(Store().PlatformOf("a").empty());
  RunMeasurements({Counted("a")}, Store(), 1, nullptr, nullptr);
  EXPECT_EQ(Store().PlatformOf("a"), util::PlatformFacts());
}

TEST_F(RunMeasurementsTest, RejectsATruncatedFile) {
  RunMeasurements({Counted("a")}, Store(), 1, nullptr, nullptr);
  const auto file = folder_.path() / "measurements" / "a.json";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 5);
  EXPECT_FALSE(Store().Find("a"));
}

TEST_F(RunMeasurementsTest, KeepsCompletedResultsWhenAMeasurementFails) {
  const Measurement broken{.id = "broken",
                           .measure = [](const util::StopRequested&) -> Json { throw std::runtime_error("no"); }};
  EXPECT_THROW(RunMeasurements({Counted("a", 2.0), broken}, Store(), 1, nullptr, nullptr), std::runtime_error);
  EXPECT_TRUE(Store().Find("a"));
  EXPECT_FALSE(Store().Find("broken"));
}

TEST_F(RunMeasurementsTest, RunsTimeMeasurementsAlone) {
  std::atomic<int> running = 0, most_running = 0;
  const auto busy = [&](bool alone) {
    return [&, alone](const util::StopRequested&) {
      const int now = ++running;
      if (alone) most_running = std::max(most_running.load(), now);
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      --running;
      return Json();
    };
  };
  RunMeasurements({{.id = "a", .measure = busy(false)},
                   {.id = "timed", .alone = true, .measure = busy(true)},
                   {.id = "b", .measure = busy(false)},
                   {.id = "timed_too", .alone = true, .measure = busy(true)}},
                  Store(), 2, nullptr, nullptr);
  EXPECT_EQ(most_running, 1);
}

TEST_F(RunMeasurementsTest, ThrowsForAnUnusableFolder) {
  std::ofstream(folder_.path() / "file") << "mine";
  EXPECT_THROW(MeasurementStore(folder_.path() / "file" / "measurements", "build"), InputError);
}

}  // namespace
}  // namespace touchdown::experiments
