#include "estimator/make_estimator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/error.h"
#include "models/vehicle.h"

namespace touchdown::estimator {
namespace {

EstimatorSetup NominalSetup() { return {.camera = {}, .pad = {}, .X_BC = models::Vehicle().X_BC(), .time = {}}; }

TEST(MakeEstimator, CreatesEveryNamedEstimator) {
  EXPECT_THAT(EstimatorNames(), testing::Contains("paper"));
  for (const std::string& name : EstimatorNames()) {
    EstimatorConfig config;
    config.name = name;
    EXPECT_NE(MakeEstimator(config, NominalSetup()), nullptr);
  }
}

TEST(MakeEstimator, RejectsAnUnknownNameAndListsTheAllowedNames) {
  EstimatorConfig config;
  config.name = "papyrus";
  try {
    MakeEstimator(config, NominalSetup());
    FAIL() << "created an estimator with an unknown name";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("papyrus"));
    for (const std::string& name : EstimatorNames()) EXPECT_THAT(error.what(), testing::HasSubstr(name));
  }
}

TEST(MakeEstimator, RejectsAnInvalidCameraAndAnInvalidPad) {
  EstimatorSetup no_camera = NominalSetup();
  no_camera.camera.width_px = 0;
  EXPECT_THROW(MakeEstimator({}, no_camera), InputError);
  EstimatorSetup no_pad = NominalSetup();
  no_pad.pad.ring_width_m = -0.01;
  EXPECT_THROW(MakeEstimator({}, no_pad), InputError);
}

TEST(MakeEstimator, RejectsASquareHWithoutTemplateVerification) {
  EstimatorSetup square = NominalSetup();
  square.pad.h_width_m = square.pad.h_height_m;
  EstimatorConfig config;
  EXPECT_NE(MakeEstimator(config, square), nullptr);
  config.paper.verify = paper::Verify::kNone;
  EXPECT_THROW(MakeEstimator(config, square), InputError);
}

TEST(FrameStatus, HasANameForEveryValue) {
  EXPECT_EQ(Name(FrameStatus::kOk), "ok");
  EXPECT_EQ(Name(FrameStatus::kNotFound), "not_found");
  EXPECT_EQ(Name(FrameStatus::kRejected), "rejected");
}

TEST(FrameStatus, IsReplacedByTheReasonInTables) {
  EXPECT_EQ(ReasonOrStatus(FrameStatus::kOk, ""), "ok");
  EXPECT_EQ(ReasonOrStatus(FrameStatus::kNotFound, "no_circle"), "no_circle");
  EXPECT_EQ(ReasonOrStatus(FrameStatus::kRejected, ""), "rejected");
}

}  // namespace
}  // namespace touchdown::estimator
