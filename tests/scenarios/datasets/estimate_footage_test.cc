#include "scenarios/datasets/estimate_footage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "models/error.h"
#include "scenarios/cli/flight_folder.h"
#include "scenarios/datasets/euroc_sensor.h"
#include "scenarios/datasets/poses_table.h"
#include "scenarios/datasets/tum_file.h"
#include "scenarios/runner/scenario.h"
#include "tests/support/temporary_folder.h"

namespace touchdown::datasets {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> Cells(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Cells of the named columns of a CSV text, for each row.
std::vector<std::vector<std::string>> Columns(const std::string& csv, const std::vector<std::string>& names) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = Cells(line);
  std::vector<std::vector<std::string>> rows;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells = Cells(line);
    cells.resize(header.size());
    auto& row = rows.emplace_back();
    for (const std::string& name : names) {
      row.push_back(cells.at(static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin())));
    }
  }
  return rows;
}

FootageSetup SetupOf(const FootageMetadata& metadata) {
  return {.camera = metadata.camera.value(),
          .pad = metadata.pad.value(),
          .mounting = metadata.mounting,
          .imu = metadata.imu,
          .estimator = metadata.estimator.value()};
}

/// Recording of a landing that starts in the air, with another pad than the default one and misaligned sensors.
class RecordedFlight : public ::testing::Test {
 protected:
  void Fly(const std::vector<std::string>& more = {}) {
    std::vector<runner::Override> overrides{std::string("time_limit_s=2"),
                                            std::string("criteria=[]"),
                                            std::string("expect=gave_up"),
                                            std::string("pad.outer_radius_m=0.085"),
                                            std::string("vehicle.camera.misalignment_deg=[1, -2, 3]"),
                                            std::string("vehicle.imu.misalignment_deg=[2, 1, 30]"),
                                            std::string("calibration.camera.misalignment_deg=[1.3, -2, 3]"),
                                            std::string("calibration.camera_model.fx_px=321"),
                                            std::string("calibration.imu.misalignment_deg=[2.2, 1, 29]")};
    overrides.insert(overrides.end(), more.begin(), more.end());
    const runner::Scenario scenario = runner::LoadScenario(
        std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "landing.yaml", overrides);
    cli::FlyIntoFolder(scenario, folder_ / "flight", {.recording = true});
  }
  tests::TemporaryFolder folder_;
};

TEST_F(RecordedFlight, ReproducesThePosesOfTheFlightExactly) {
  Fly();
  const auto footage = OpenFootage(folder_ / "flight");
  const FootageMetadata& metadata = footage->metadata();
  EXPECT_EQ(metadata.camera->fx_px, 321.0) << "assumed calibration";
  const EurocCamera camera = ReadEurocCamera(folder_ / "flight/recording/mav0/cam0/sensor.yaml");
  EXPECT_EQ(camera.model, metadata.camera);
  EXPECT_EQ(camera.X_BC.matrix(), metadata.mounting->X_BC.matrix());
  EXPECT_EQ(ReadEurocMounting(folder_ / "flight/recording/mav0/imu0/sensor.yaml").matrix(),
            metadata.mounting->X_BU.matrix());
  EXPECT_EQ(runner::LoadCameraModel(folder_ / "flight/recording/camera.yaml"), metadata.camera);
  const auto estimates = EstimateFootage(*footage, SetupOf(metadata));
  const std::vector<std::string> names = {"t_s",      "status",    "x_m",     "y_m",      "z_m",
                                          "roll_deg", "pitch_deg", "yaw_deg", "pad_u_px", "pad_v_px"};
  const auto flown = Columns(folder_.Content("flight/frames.csv"), names);
  EXPECT_EQ(Columns(PosesCsv(estimates, metadata.time), names), flown);
  EXPECT_GT(flown.size(), 100u);
  EXPECT_EQ(runner::TumText(PosesTrajectory(estimates, metadata.time), metadata.time),
            folder_.Content("flight/estimate.tum"));
}

TEST_F(RecordedFlight, ReproducesThePosesOfAFlightFromTheGround) {
  const runner::Scenario scenario = runner::LoadScenario(
      std::filesystem::path(TOUCHDOWN_SOURCE_DIR) / "scenarios" / "flights" / "takeoff_hover_land.yaml",
      std::vector<runner::Override>{std::string("time_limit_s=4")});
  cli::FlyIntoFolder(scenario, folder_ / "flight", {.recording = true});
  const auto footage = OpenFootage(folder_ / "flight");
  const auto estimates = EstimateFootage(*footage, SetupOf(footage->metadata()));
  EXPECT_GT(PosesTrajectory(estimates, scenario.time).size(), 50u);
  EXPECT_EQ(runner::TumText(PosesTrajectory(estimates, scenario.time), scenario.time),
            folder_.Content("flight/estimate.tum"));
}

TEST_F(RecordedFlight, IsReplacedByTheNextRunUnlessItContainsOtherFiles) {
  Fly({std::string("time_limit_s=0.2")});
  EXPECT_NO_THROW(Fly({std::string("time_limit_s=0.1")}));
  EXPECT_LT(OpenFootage(folder_ / "flight")->metadata().frame_count, 8u);
  folder_.Put("flight/recording/mav0/cam0/notes.txt", "mine");
  try {
    Fly({std::string("time_limit_s=0.1")});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("notes.txt is not a file of an earlier run"));
  }
  EXPECT_EQ(folder_.Content("flight/recording/mav0/cam0/notes.txt"), "mine");
}

TEST_F(RecordedFlight, GivesCameraPosesWithoutAMountingAndChoosesHypothesesWithoutAnImu) {
  Fly();
  const auto footage = OpenFootage(folder_ / "flight");
  FootageSetup setup = SetupOf(footage->metadata());
  const SensorMounting mounting = setup.mounting.value();
  setup.mounting.reset();
  setup.imu.clear();
  const auto estimates = EstimateFootage(*footage, setup);
  std::size_t chosen_by_artwork = 0, correct = 0;
  std::map<models::Tick, Eigen::Isometry3d> truth;
  for (const TimedPose& pose : ReadTumFile(folder_ / "flight/truth.tum")) {
    truth[footage->metadata().time.FromSeconds(pose.t_s)] = pose.X_WB;
  }
  for (const FootageEstimate& estimate : estimates) {
    if (!estimate.result.pose || estimate.result.choice->reason != estimator::PoseChoice::Reason::kArtwork) continue;
    ++chosen_by_artwork;
    const Eigen::Isometry3d X_WC = truth.at(*estimate.mid_exposure) * mounting.X_BC;
    correct += (estimate.result.pose->X_WB.translation() - X_WC.translation()).norm() < 0.1;
  }
  EXPECT_GT(chosen_by_artwork, 40u);
  EXPECT_GE(correct, chosen_by_artwork * 95 / 100);
  const std::string choices = ChoicesCsv(estimates);
  EXPECT_THAT(choices, HasSubstr(",artwork,,,"));
}

/// Footage of `count` uniform frames of one size.
class BlankFootage final : public Footage {
 public:
  BlankFootage(int width, int height, std::size_t count) : image_(width, height, 200), remaining_(count) {}
  const FootageMetadata& metadata() const override { return metadata_; }
  std::optional<FootageFrame> Next() override {
    if (remaining_-- == 0) return std::nullopt;
    return FootageFrame{"a, \"blank\".png", std::nullopt, image_};
  }

 private:
  FootageMetadata metadata_;
  models::Image image_;
  std::size_t remaining_;
};

TEST(EstimateFootage, LeavesCellsWithoutValueEmpty) {
  BlankFootage footage(640, 480, 1);
  const auto estimates = EstimateFootage(footage, {});
  EXPECT_EQ(PosesCsv(estimates, footage.metadata().time),
            "frame,source,t_s,status,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,pad_u_px,pad_v_px,"
            "ellipse_a_px,ellipse_b_px,ellipse_angle_deg,box_x_px,box_y_px,box_w_px,box_h_px\n"
            "0,\"a, \"\"blank\"\".png\",,no_component,,,,,,,,,,,,,,,\n");
}

TEST(EstimateFootage, RejectsAFrameOfAnotherSizeThanTheCamera) {
  BlankFootage footage(320, 240, 1);
  try {
    EstimateFootage(footage, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("image is 320 x 240 px, but the camera calibration is for 640 x 480 px"));
  }
}

TEST(EstimateFootage, RejectsAnImuWithFramesWithoutTimes) {
  BlankFootage footage(640, 480, 1);
  FootageSetup setup;
  setup.imu.resize(1);
  EXPECT_THROW(EstimateFootage(footage, setup), InputError);
}

}  // namespace
}  // namespace touchdown::datasets
