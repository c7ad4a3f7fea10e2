#include "scenarios/experiments/take_measurements.h"

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

class TakeMeasurementsTest : public testing::Test {
 protected:
  Measurement Counted(const std::string& id, double expected_s = 1.0) {
    return {.id = id, .expected_s = expected_s, .take = [this, id](const util::StopRequested&) {
              ++taken_;
              return Json{{"of", id}};
            }};
  }
  MeasurementStore Store(const std::string& origin = "build 1") { return {folder_.path() / "measurements", origin}; }

  tests::TemporaryFolder folder_;
  std::atomic<int> taken_ = 0;
};

TEST_F(TakeMeasurementsTest, BringsAllInWhateverOrder) {
  std::vector<double> shares;
  const Measured measured = TakeMeasurements({Counted("a"), Counted("b", 5.0), Counted("c")}, Store(), 2, nullptr,
                                             [&](double share, const std::string&) { shares.push_back(share); });
  ASSERT_EQ(measured.size(), 3u);
  EXPECT_EQ(measured.at("b").at("of"), "b");
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_DOUBLE_EQ(shares.back(), 1.0);
}

TEST_F(TakeMeasurementsTest, GoesOnWhereItWasStopped) {
  std::vector<Measurement> measurements{Counted("a"), Counted("b"), Counted("c")};
  const auto stop = [this] { return taken_ >= 2; };
  EXPECT_THROW(TakeMeasurements(measurements, Store(), 1, stop, nullptr), util::Interrupted);
  EXPECT_EQ(taken_, 2);
  EXPECT_EQ(TakeMeasurements(measurements, Store(), 1, nullptr, nullptr).size(), 3u);
  EXPECT_EQ(taken_, 3);
}

TEST_F(TakeMeasurementsTest, TakesAgainWhatAnotherBuildMeasured) {
  TakeMeasurements({Counted("a")}, Store("build 1"), 1, nullptr, nullptr);
  TakeMeasurements({Counted("a")}, Store("build 1"), 1, nullptr, nullptr);
  EXPECT_EQ(taken_, 1);
  TakeMeasurements({Counted("a")}, Store("build 2"), 1, nullptr, nullptr);
  EXPECT_EQ(taken_, 2);
}

TEST_F(TakeMeasurementsTest, RemembersWhereItMeasured) {
  EXPECT_TRUE(Store().PlatformOf("a").empty());
  TakeMeasurements({Counted("a")}, Store(), 1, nullptr, nullptr);
  EXPECT_EQ(Store().PlatformOf("a"), util::PlatformFacts());
}

TEST_F(TakeMeasurementsTest, TakesAgainWhatWasTruncated) {
  TakeMeasurements({Counted("a")}, Store(), 1, nullptr, nullptr);
  const auto file = folder_.path() / "measurements" / "a.json";
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 5);
  EXPECT_FALSE(Store().Find("a"));
}

TEST_F(TakeMeasurementsTest, KeepsWhatIsDoneWhenOneFails) {
  const Measurement broken{.id = "broken",
                           .take = [](const util::StopRequested&) -> Json { throw std::runtime_error("no"); }};
  EXPECT_THROW(TakeMeasurements({Counted("a", 2.0), broken}, Store(), 1, nullptr, nullptr), std::runtime_error);
  EXPECT_TRUE(Store().Find("a"));
  EXPECT_FALSE(Store().Find("broken"));
}

TEST_F(TakeMeasurementsTest, MeasuresTimesAlone) {
  std::atomic<int> running = 0, most = 0;
  const auto busy = [&](bool alone) {
    return [&, alone](const util::StopRequested&) {
      const int now = ++running;
      if (alone) most = std::max(most.load(), now);
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      --running;
      return Json();
    };
  };
  TakeMeasurements({{.id = "a", .take = busy(false)},
                    {.id = "timed", .alone = true, .take = busy(true)},
                    {.id = "b", .take = busy(false)},
                    {.id = "timed_too", .alone = true, .take = busy(true)}},
                   Store(), 2, nullptr, nullptr);
  EXPECT_EQ(most, 1);
}

TEST_F(TakeMeasurementsTest, SaysWhatIsWrongWithTheFolder) {
  std::ofstream(folder_.path() / "file") << "mine";
  EXPECT_THROW(MeasurementStore(folder_.path() / "file" / "measurements", "build"), InputError);
}

}  // namespace
}  // namespace touchdown::experiments
