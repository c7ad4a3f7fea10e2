#include "scenarios/experiments/yaw_study.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/error.h"

namespace touchdown::experiments {
namespace {

using Rows = std::vector<YawErrors>;

/// Errors at the default height, where the H is 100 px high.
const Rows& DefaultRows() {
  static const Rows rows = StudyYaw();
  return rows;
}

double Largest(const Rows& rows, YawMethod method) { return SummarizeErrors(rows, method).largest_deg; }

// The published bounds of Sec. IV-C.3.
TEST(YawStudy, MeetsThePublishedErrorsWithAnHOfAHundredPixels) {
  const Rows& rows = DefaultRows();
  ASSERT_EQ(rows.size(), 360u);
  for (const YawMethod method : {YawMethod::kEllipseOfHInteger, YawMethod::kEllipseOfHSubpixel}) {
    EXPECT_LT(Largest(rows, method), 3.0);
  }
  for (const YawMethod method : {YawMethod::kMomentsOfHBinary, YawMethod::kMomentsOfHGray}) {
    EXPECT_LT(Largest(rows, method), 1.0);
  }
  EXPECT_LT(Largest(rows, YawMethod::kEllipseOfRectangleInteger), Largest(rows, YawMethod::kEllipseOfHInteger));
  EXPECT_LT(Largest(rows, YawMethod::kEllipseOfRectangleSubpixel), Largest(rows, YawMethod::kEllipseOfHSubpixel));
}

TEST(YawStudy, IsExactAlongTheImageAxesWithEveryMethod) {
  const Rows& rows = DefaultRows();
  for (const int yaw_deg : {0, 90, 180, 270}) {
    for (const double error_deg : rows[static_cast<std::size_t>(yaw_deg)].error_deg) EXPECT_NEAR(error_deg, 0.0, 0.05);
  }
}

TEST(YawStudy, ErrorRepeatsAfterHalfATurn) {
  const Rows& rows = DefaultRows();
  for (std::size_t i = 0; i < 180; ++i) {
    EXPECT_EQ(rows[i].yaw_deg, static_cast<int>(i));
    EXPECT_NEAR(rows[i].Of(YawMethod::kMomentsOfHGray), rows[i + 180].Of(YawMethod::kMomentsOfHGray), 0.02);
  }
}

TEST(YawStudy, ErrorGrowsWithHeight) {
  const Rows& near = DefaultRows();
  const Rows far = StudyYaw(1.0);
  for (const YawMethod method :
       {YawMethod::kEllipseOfHInteger, YawMethod::kMomentsOfHBinary, YawMethod::kEllipseOfRectangleInteger}) {
    EXPECT_GT(SummarizeErrors(far, method).rms_deg, SummarizeErrors(near, method).rms_deg);
  }
}

TEST(YawStudy, RejectsHeightsWithoutASeparateLetter) {
  for (const double height_m : {0.0, -1.0, 5.0, std::nan("")}) EXPECT_THROW(StudyYaw(height_m), InputError);
}

TEST(SummarizeErrors, ReturnsTheLargestAbsoluteErrorAndTheRms) {
  Rows rows(2);
  rows[0].error_deg = {-4.0};
  rows[1].error_deg = {3.0};
  EXPECT_EQ(SummarizeErrors(rows, YawMethod::kEllipseOfHInteger).largest_deg, 4.0);
  EXPECT_NEAR(SummarizeErrors(rows, YawMethod::kEllipseOfHInteger).rms_deg, std::sqrt(12.5), 1e-12);
  EXPECT_EQ(SummarizeErrors({}, YawMethod::kEllipseOfHInteger).rms_deg, 0.0);
}

}  // namespace
}  // namespace touchdown::experiments
