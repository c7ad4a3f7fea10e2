// The bag of a flight, read by the reader of ROS and read back as footage.
#include "scenarios/datasets/flight_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "models/error.h"
#include "scenarios/cli/flight_folder.h"
#include "scenarios/datasets/estimate_footage.h"
#include "scenarios/datasets/footage.h"
#include "scenarios/datasets/poses_table.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/util/sha256.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::StartsWith;
using tests::ThrowsInputError;

/// Landing that starts in the air, with misaligned sensors and lens distortion.
runner::Scenario Landing(double time_limit_s) {
  return runner::LoadScenario(
      fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "landing.yaml",
      std::vector<runner::Override>{"time_limit_s=" + std::to_string(time_limit_s), std::string("criteria=[]"),
                                    std::string("expect=gave_up"), std::string("camera.model.k1=-0.05"),
                                    std::string("vehicle.camera.misalignment_deg=[1, -2, 3]"),
                                    std::string("vehicle.imu.misalignment_deg=[2, 1, 30]")});
}

class FlownBag : public ::testing::Test {
 protected:
  void Fly(const runner::Scenario& scenario, const std::string& name = "flight") const {
    cli::FlyIntoFolder(scenario, folder_ / name, {.video = false, .recording = true, .bag = true});
  }
  tests::TemporaryFolder folder_;
};

std::string PosesOf(const fs::path& input) {
  const auto footage = OpenFootage(input);
  const FootageMetadata& metadata = footage->metadata();
  const auto estimates = EstimateFootage(*footage, {.camera = metadata.camera.value(),
                                                    .pad = metadata.pad.value(),
                                                    .mounting = metadata.mounting,
                                                    .imu = metadata.imu,
                                                    .estimator = metadata.estimator.value()});
  return runner::TumText(PosesTrajectory(estimates, metadata.time), metadata.time);
}

/// One line "TIME_NS SHA256" for each image.
std::string ImageDigests(Footage& footage) {
  std::ostringstream lines;
  while (const auto frame = footage.Next()) {
    const std::string pixels(frame->image.pixels.begin(), frame->image.pixels.end());
    lines << footage.metadata().time.ToNanoseconds(frame->mid_exposure.value()) << " " << util::Sha256(pixels) << "\n";
  }
  return lines.str();
}

TEST_F(FlownBag, MatchesTheFilesOfTheFlightExactly) {
  if (std::system("/usr/bin/python3 -c 'import rosbag' 2>/dev/null") != 0) {
    GTEST_SKIP() << "python3-rosbag is missing";
  }
  Fly(Landing(2.0));
  const std::string script =
      (fs::path(TOUCHDOWN_SOURCE_DIR) / "tests" / "scenarios" / "datasets" / "read_flight_bag.py").string();
  const tests::ProgramRun run =
      tests::RunProgram("/usr/bin/python3", {"-B", script, (folder_ / "flight").string()}, folder_.path());
  EXPECT_EQ(run.status, 0) << run.err;
  const auto recording = OpenFootage(folder_ / "flight");
  EXPECT_EQ(run.out, ImageDigests(*recording));
  EXPECT_GT(recording->metadata().frame_count, 100u);
}

TEST_F(FlownBag, ReproducesThePosesAndImagesOfTheFlight) {
  Fly(Landing(2.0));
  const std::string poses = folder_.Content("flight/estimate.tum");
  EXPECT_EQ(PosesOf(folder_ / "flight" / "flight.bag"), poses);
  EXPECT_EQ(PosesOf(folder_ / "flight"), poses);
  EXPECT_GT(std::count(poses.begin(), poses.end(), '\n'), 100);
  const auto bag = OpenFootage(folder_ / "flight" / "flight.bag"), recording = OpenFootage(folder_ / "flight");
  EXPECT_EQ(bag->metadata().frame_count, recording->metadata().frame_count);
  EXPECT_NEAR(bag->metadata().frames_per_s, 60.0, 1e-3);
  EXPECT_EQ(ImageDigests(*bag), ImageDigests(*recording));
}

TEST_F(FlownBag, ReproducesThePosesOfAFlightFromTheGround) {
  const runner::Scenario scenario =
      runner::LoadScenario(fs::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "takeoff_hover_land.yaml",
                           std::vector<runner::Override>{std::string("time_limit_s=4")});
  Fly(scenario);
  const std::string poses = folder_.Content("flight/estimate.tum");
  EXPECT_EQ(PosesOf(folder_ / "flight" / "flight.bag"), poses);
  EXPECT_GT(std::count(poses.begin(), poses.end(), '\n'), 50);
}

TEST_F(FlownBag, IsBitIdenticalForTheSameFlight) {
  Fly(Landing(0.3), "a");
  Fly(Landing(0.3), "b");
  const std::string bytes = folder_.Content("a/flight.bag");
  EXPECT_GT(bytes.size(), 1'000'000u);
  EXPECT_TRUE(bytes == folder_.Content("b/flight.bag"));
}

TEST_F(FlownBag, IsRejectedWhenTruncated) {
  Fly(Landing(0.3));
  const std::string bytes = folder_.Content("flight/flight.bag");
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{5}, std::size_t{5000}, bytes.size() / 2, bytes.size() - 9000, bytes.size() - 1}) {
    const fs::path cut = folder_.Put("cut.bag", bytes.substr(0, size));
    try {
      OpenFootage(cut);
      ADD_FAILURE() << size;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), cut.string() + ": not a readable ROS bag, or truncated") << size;
    }
  }
}

TEST_F(FlownBag, IsWrittenAndReadByTheProgramWhichKeepsEarlierPosesAfterAnError) {
  const auto run = [this](const std::vector<std::string>& arguments) {
    return tests::RunProgram(TOUCHDOWN_PROGRAM, arguments, folder_.path());
  };
  folder_.Put("short.yaml", "script:\n  - {do: takeoff, height_m: 1}\n  - {do: land}\ntime_limit_s: 0.1\n");
  EXPECT_EQ(run({"fly", "short.yaml", "--bag", "--video", "off", "--out", "flight"}).status, 1);
  const tests::ProgramRun estimated =
      run({"estimate", "flight/flight.bag", "--topic", "/camera/image_raw", "--out", "poses"});
  EXPECT_EQ(estimated.status, 0) << estimated.err;
  const std::string poses = folder_.Content("poses/poses.csv");
  EXPECT_THAT(poses, StartsWith("frame,source"));

  folder_.Put("cut.bag", folder_.Content("flight/flight.bag").substr(0, 100'000));
  const tests::ProgramRun cut = run({"estimate", "cut.bag", "--out", "poses"});
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.err, "error: cut.bag: not a readable ROS bag, or truncated\n");
  EXPECT_EQ(folder_.Content("poses/poses.csv"), poses);
  EXPECT_EQ(run({"estimate", "flight", "--topic", "/camera/image_raw", "--out", "poses"}).status, 2);
  EXPECT_EQ(run({"fly", "short.yaml", "--video", "off", "--out", "flight"}).status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "flight" / "flight.bag"));
}

void WriteBag(const runner::Scenario& scenario, const fs::path& file) {
  FlightBag bag(scenario, file);
  runner::FlightObserver* const observers[] = {&bag};
  bag.Finish(runner::FlyClosedLoop(scenario, observers, nullptr));
}

TEST_F(FlownBag, ReportsAFullDiskAndRemovesTheFile) {
  const runner::Scenario scenario = Landing(0.3);
  const fs::path file = folder_ / "flight.bag";
  ASSERT_NO_THROW(WriteBag(scenario, file));
  const auto full_size = static_cast<rlim_t>(fs::file_size(file));
  fs::remove(file);
  // The disk is full at the start, in the frames, in the truth, in the index, and when the file is closed.
  for (const rlim_t bytes :
       {rlim_t{0}, rlim_t{5000}, full_size / 2, full_size - 50'000, full_size - 3000, full_size - 1}) {
    const tests::FileSizeLimit disk(bytes);
    EXPECT_THAT([&] { WriteBag(scenario, file); }, ThrowsInputError(StartsWith("bag flight.bag: cannot be written")))
        << bytes;
    EXPECT_FALSE(fs::exists(file)) << bytes;
  }
}

TEST_F(FlownBag, ReportsAPathThatCannotBeWritten) {
  const runner::Scenario scenario = Landing(0.1);
  EXPECT_THAT([&] { WriteBag(scenario, folder_ / "none" / "flight.bag"); },
              ThrowsInputError(StartsWith("bag flight.bag: cannot be written")));
  fs::create_directories(folder_ / "folder.bag");
  EXPECT_THAT([&] { WriteBag(scenario, folder_ / "folder.bag"); },
              ThrowsInputError(StartsWith("bag folder.bag: cannot be written")));
  EXPECT_TRUE(fs::is_directory(folder_ / "folder.bag"));
}

TEST_F(FlownBag, RemovesAnUnfinishedBag) {
  const fs::path file = folder_ / "flight.bag";
  {
    FlightBag bag(Landing(0.1), file);
    bag.OnImu({.tick = 0}, true);
    EXPECT_TRUE(fs::exists(file));
  }
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace touchdown::datasets
