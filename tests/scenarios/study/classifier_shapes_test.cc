#include "scenarios/study/classifier_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace touchdown::scenarios {
namespace {

std::vector<GroundShape> ShapesOfPad(const models::LandingPad& pad) {
  sim::SceneConfig bare;
  bare.posters = bare.lone_circles = bare.lone_letters = bare.objects = 0;
  return ShapesOf(sim::MakeScene(bare, pad, 1));
}

TEST(ClassifierShapes, OfAPadAreItsRingAndItsHWithoutItsMarks) {
  models::LandingPad marked;
  marked.marks = {{.shape = models::PadMark::Shape::kDisc, .centre_m = {0.0, 0.06}, .diameter_m = 0.02},
                  {.shape = models::PadMark::Shape::kBar, .centre_m = {0.05, 0.0}, .length_m = 0.02, .width_m = 0.05}};
  const std::vector<GroundShape> shapes = ShapesOfPad(marked), plain = ShapesOfPad({});
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].label, estimator::FrameTrace::Label::kCircle);
  EXPECT_EQ(shapes[1].label, estimator::FrameTrace::Label::kH);
  EXPECT_NEAR(shapes[0].radius_m, 0.090, 0.001);
  EXPECT_NEAR(shapes[1].radius_m, std::hypot(0.050, 0.028), 0.001);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(shapes[i].hull_m, plain[i].hull_m);
    EXPECT_EQ(shapes[i].ink_share, plain[i].ink_share);
  }
}

}  // namespace
}  // namespace touchdown::scenarios
