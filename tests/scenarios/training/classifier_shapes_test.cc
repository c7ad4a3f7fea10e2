#include "scenarios/training/classifier_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/empty_room.h"

namespace touchdown::training {
namespace {

std::vector<GroundShape> ShapesOfPad(const models::LandingPad& pad) {
  return FindGroundShapes(sim::MakeScene(tests::EmptyRoomConfig(), pad, 1));
}

TEST(ClassifierShapes, OfAPadAreRingAndLetterWithoutMarkings) {
  models::LandingPad marked;
  marked.marks = {
      {.shape = models::PadMarking::Shape::kDisc, .center_m = {0.0, 0.06}, .diameter_m = 0.02},
      {.shape = models::PadMarking::Shape::kBar, .center_m = {0.05, 0.0}, .length_m = 0.02, .width_m = 0.05}};
  const std::vector<GroundShape> shapes = ShapesOfPad(marked), plain = ShapesOfPad({});
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].label, estimator::paper::ComponentClass::kCircle);
  EXPECT_EQ(shapes[1].label, estimator::paper::ComponentClass::kH);
  EXPECT_NEAR(shapes[0].radius_m, 0.090, 0.001);
  EXPECT_NEAR(shapes[1].radius_m, std::hypot(0.050, 0.028), 0.001);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EXPECT_EQ(shapes[i].hull_m, plain[i].hull_m);
    EXPECT_EQ(shapes[i].ink_fraction, plain[i].ink_fraction);
  }
}

TEST(ClassifierShapes, OfARectanglePadIncludeASolidRectangle) {
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  const std::vector<GroundShape> shapes = ShapesOfPad(pad);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[1].label, estimator::paper::ComponentClass::kH);
  EXPECT_NEAR(shapes[1].radius_m, std::hypot(0.050, 0.028), 0.001);
  EXPECT_EQ(shapes[1].ink_fraction, 1.0);
  EXPECT_NEAR(shapes[1].gap_m, 0.056, 0.002) << "width of the rectangle";
}

TEST(ClassifierShapes, OfASceneIncludeLoneLettersOfThePadsKind) {
  sim::SceneConfig scene = tests::EmptyRoomConfig();
  scene.lone_letters = 3;
  models::LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  sim::Scene drawn = sim::MakeScene(scene, pad, 1);
  const std::vector<GroundShape> rectangles = FindGroundShapes(drawn);
  ASSERT_EQ(rectangles.size(), 5u);
  for (std::size_t i = 2; i < rectangles.size(); ++i) EXPECT_EQ(rectangles[i].ink_fraction, 1.0);
  drawn.items.back().kind = sim::SceneItem::Kind::kLetterH;
  EXPECT_EQ(FindGroundShapes(drawn).size(), 4u) << "an H is clutter for rectangle pads";
}

}  // namespace
}  // namespace touchdown::training
