#include "scenarios/datasets/tum_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/support/throws_input_error.h"

namespace touchdown::datasets {
namespace {

using ::testing::HasSubstr;
using tests::ThrowsInputError;

class TumFile : public ::testing::Test {
 protected:
  auto Reading(const std::string& text) const {
    return [this, text] { ReadTumFile(folder_.Put("poses.tum", text)); };
  }
  tests::TemporaryFolder folder_;
};

TEST_F(TumFile, ReadsPosesWithScalarLastQuaternions) {
  const auto poses =
      ReadTumFile(folder_.Put("poses.tum", "# t x y z\n\n0.5 1 2 3 0 0 0 1\n  1e0 0 0 1 0 0 0.6 0.8\r\n"));
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].t_s, 0.5);
  EXPECT_EQ(poses[0].X_WB.translation(), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(poses[0].X_WB.linear(), Eigen::Matrix3d::Identity());
  // Rotation about Z by 2 atan(0.6 / 0.8).
  EXPECT_NEAR(poses[1].X_WB.linear()(1, 0), 2.0 * 0.6 * 0.8, 1e-12);
}

TEST_F(TumFile, NamesTheLineOfAnError) {
  EXPECT_THAT(Reading("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0\n"),
              ThrowsInputError(HasSubstr("poses.tum:2: must be eight numbers")));
  EXPECT_THAT(Reading("1 0 0 0 0 0 0 1 9\n"),
              ThrowsInputError(HasSubstr("poses.tum:1: must be exactly eight numbers")));
  EXPECT_THAT(Reading("1 0 0 nan 0 0 0 1\n"), ThrowsInputError(HasSubstr("poses.tum:1: must be eight numbers")));
  EXPECT_THAT(Reading("1 0 0 0 0 0 0 2\n"), ThrowsInputError(HasSubstr("poses.tum:1: quaternion has length 2")));
  EXPECT_THAT(Reading("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"),
              ThrowsInputError(HasSubstr("poses.tum:2: time is not after")));
  EXPECT_THAT(Reading("# nothing\n"), ThrowsInputError(HasSubstr("poses.tum: no poses")));
}

}  // namespace
}  // namespace touchdown::datasets
