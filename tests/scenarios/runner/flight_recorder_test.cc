#include "scenarios/runner/flight_recorder.h"

#include <gtest/gtest.h>

#include "models/vehicle.h"

namespace touchdown::runner {
namespace {

using controller::Phase;

class FlightRecorderTest : public ::testing::Test {
 protected:
  /// Records ticks in which the vehicle sinks by 1 mm each.
  void Pass(int ticks, Phase phase, bool contact = false, bool covered = false) {
    for (int i = 0; i < ticks; ++i) {
      truth_.X_WB.translation() << 0.0, 0.0, 1.0 - 0.001 * static_cast<double>(truth_.tick);
      truth_.v_WB.z() = -static_cast<double>(truth_.tick);
      truth_.gear_in_contact = contact;
      recorder_.OnTruth(truth_, truth_.X_WB * models::Vehicle().X_BC(), covered, phase);
      ++truth_.tick;
    }
  }
  estimator::FrameResult Estimate(models::Tick mid_exposure) const {
    estimator::FrameResult estimate;
    estimate.mid_exposure = mid_exposure;
    return estimate;
  }

  sim::TrueState truth_;
  FlightRecorder recorder_{Scenario()};
};

TEST_F(FlightRecorderTest, RecordsTruthAtMidExposure) {
  Pass(101, Phase::kHover);
  const FrameRecord& record = recorder_.OnFrame(Estimate(76), 1.0, {.total_ms = 2.0, .geometry_ms = 0.5});
  EXPECT_DOUBLE_EQ(record.X_WB.translation().z(), 1.0 - 0.076);
  EXPECT_EQ(record.delivered, 100);
  EXPECT_TRUE(record.ring_in_view);
  ASSERT_TRUE(record.true_pad_px.has_value());
  EXPECT_NEAR(record.true_pad_px->x(), 319.5, 1e-9);
}

TEST_F(FlightRecorderTest, RecordsNoTruePadWhileItIsCovered) {
  Pass(50, Phase::kHover, false, true);
  Pass(10, Phase::kHover, false, false);
  const FrameRecord record = recorder_.OnFrame(Estimate(49), 0.0, {});
  EXPECT_FALSE(record.ring_in_view);
  EXPECT_FALSE(record.true_pad_px.has_value());
  EXPECT_TRUE(record.pad_is_covered);
  EXPECT_TRUE(recorder_.OnFrame(Estimate(50), 0.0, {}).ring_in_view);
}

TEST_F(FlightRecorderTest, RejectsFrameOlderThanHistory) {
  Pass(200, Phase::kHover);
  EXPECT_THROW(recorder_.OnFrame(Estimate(100), 0.0, {}), std::logic_error);
}

TEST_F(FlightRecorderTest, RecordsFirstContactOfLandingOnly) {
  Pass(10, Phase::kStandby, true);
  Pass(10, Phase::kHover);
  Pass(10, Phase::kBlindDescent);
  Pass(3, Phase::kBlindDescent, true);
  Pass(5, Phase::kTouchdown);
  Pass(5, Phase::kTouchdown, true);
  const FlightLog log = recorder_.Finish(Outcome::kLanded, "");
  ASSERT_TRUE(log.touchdown.has_value());
  EXPECT_EQ(log.touchdown->at.tick, 30);
  EXPECT_EQ(log.touchdown->before.tick, 29);
  EXPECT_EQ(log.end, 42);
}

TEST_F(FlightRecorderTest, RecordsNoTouchdownWithoutTakeoff) {
  Pass(10, Phase::kStandby, true);
  Pass(10, Phase::kTouchdown, true);
  EXPECT_FALSE(recorder_.Finish(Outcome::kLanded, "").touchdown.has_value());
}

}  // namespace
}  // namespace touchdown::runner
