// `touchdown pad`, run as a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/program_fixture.h"

namespace touchdown::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class PadCommand : public tests::ProgramFixture {};

TEST_F(PadCommand, WritesASheetAndADescription) {
  EXPECT_EQ(Run({"pad", "--out", "print/pad.pdf"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "print" / "pad.pdf"));
  // The description that it wrote gives the same pad, and is not rewritten.
  const auto changed = fs::last_write_time(folder_ / "print" / "pad.yaml");
  EXPECT_EQ(Run({"pad", "--out", "print/pad.svg", "--pad", "print/pad.yaml"}).status, 0);
  EXPECT_EQ(fs::last_write_time(folder_ / "print" / "pad.yaml"), changed);
  EXPECT_EQ(Run({"pad", "--out", "print/pad.pdf"}).status, 0);
  // A scenario can use the description.
  folder_.Put("fly.yaml", kTakeoffAndLanding + "pad: print/pad.yaml\ntime_limit_s: 0.1\n");
  EXPECT_EQ(Run({"fly", "fly.yaml", "--out", "result"}).status, 1);
}

TEST_F(PadCommand, WritesAPadWithMarkingsForFlightsAndEstimates) {
  folder_.Put("mine.yaml", "marks: [{shape: bar, x_m: 0, y_m: 0.05, length_m: 0.02, width_m: 0.004, angle_deg: 30}]\n");
  ASSERT_EQ(Run({"pad", "--out", "pad.pdf", "--pad", "mine.yaml"}).status, 0);
  folder_.Put("short.yaml", "start: {airborne: true}\nscript: [{do: hover, duration_s: 0.1}]\npad: pad.yaml\n");
  EXPECT_EQ(Run({"fly", "short.yaml", "--out", "a", "--record", "--video", "off"}).status, 0);
  EXPECT_EQ(Run({"pad", "--out", "a/recording/pad.svg", "--pad", "mine.yaml"}).status, 0)
      << "its pad.yaml has the same content";
  EXPECT_EQ(Run({"estimate", "a", "--pad", "pad.yaml", "--out", "b"}).status, 0);

  folder_.Put("mine.yaml", "marks:\n  - {shape: disc, x_m: 0, y_m: 0.05}\n");
  EXPECT_THAT(ErrorOf({"estimate", "a", "--pad", "mine.yaml", "--out", "c"}),
              HasSubstr("mine.yaml:2: marks.0.diameter_m: must be given"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(PadCommand, KeepsAnEditedDescription) {
  ASSERT_EQ(Run({"pad", "--out", "pad.pdf"}).status, 0);
  folder_.Put("pad.yaml", "ring_width_m: 0.012\n");
  const auto written = fs::last_write_time(folder_ / "pad.pdf");
  EXPECT_THAT(ErrorOf({"pad", "--out", "pad.pdf"}), HasSubstr("pad.yaml: already exists"));
  EXPECT_EQ(folder_.Content("pad.yaml"), "ring_width_m: 0.012\n");
  EXPECT_EQ(fs::last_write_time(folder_ / "pad.pdf"), written);
  EXPECT_EQ(Run({"pad", "--out", "pad.pdf", "--pad", "pad.yaml"}).status, 0);
}

TEST_F(PadCommand, KeepsUserFilesAndRejectsInvalidPads) {
  folder_.Put("mine.pdf", "a user's");
  folder_.Put("described.yaml", "a user's");
  folder_.Put("bad.yaml", "outer_radius_m: -1\n");
  const std::set<std::string> before = Names();
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"pad", "--out", "mine.pdf"},
                                             {"pad", "--out", "described.pdf"},
                                             {"pad", "--out", "pad.png"},
                                             {"pad", "--out", "pad.pdf", "--pad", "bad.yaml"},
                                             {"pad", "--out", "pad.pdf", "--pad", "none.yaml"}}) {
    EXPECT_NE(ErrorOf(arguments), "");
  }
  EXPECT_EQ(Names(), before);
}

}  // namespace
}  // namespace touchdown::cli
