#include "scenarios/report/pad_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "estimator/paper/paper_estimator.h"
#include "models/angles.h"
#include "models/error.h"
#include "models/vehicle.h"
#include "tests/support/synthetic_pad.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;
using models::LandingPad;

constexpr int kDotsPerInch = 600;
constexpr double kPxPerMm = kDotsPerInch / 25.4;

/// Rasterized page of a pad sheet. Page coordinates are in mm, x to the right and y down.
class Raster {
 public:
  explicit Raster(const LandingPad& pad) {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const fs::path folder = fs::path(::testing::TempDir()) / ("pad_sheet_test_" + test);
    fs::create_directories(folder);
    std::ofstream(folder / "pad.pdf", std::ios::binary) << PadSheet(pad, SheetFormat::kPdf);
    const std::string command = "pdftoppm -r " + std::to_string(kDotsPerInch) + " -gray -singlefile '" +
                                (folder / "pad.pdf").string() + "' '" + (folder / "pad").string() + "'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
    image_ = cv::imread((folder / "pad.pgm").string(), cv::IMREAD_GRAYSCALE);
    fs::remove_all(folder);
    if (image_.empty()) throw std::runtime_error("pdftoppm wrote no image");
  }

  double width_mm() const { return image_.cols / kPxPerMm; }
  double height_mm() const { return image_.rows / kPxPerMm; }

  /// Interpolated gray level; 255 outside the page.
  double At(const Vector2d& p_mm) const {
    const double u = p_mm.x() * kPxPerMm - 0.5, v = p_mm.y() * kPxPerMm - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    if (left < 0 || top < 0 || left + 1 >= image_.cols || top + 1 >= image_.rows) return 255.0;
    const double wu = u - left, wv = v - top;
    return (1 - wv) * ((1 - wu) * image_(top, left) + wu * image_(top, left + 1)) +
           wv * ((1 - wu) * image_(top + 1, left) + wu * image_(top + 1, left + 1));
  }

  /// Distance in mm along `direction` from `from`, which must be black, to the end of the black area.
  double InkEnd(const Vector2d& from_mm, const Vector2d& direction) const {
    constexpr double kStep_mm = 0.005;
    double along = 0.0;
    while (At(from_mm + along * direction) < 127.5) along += kStep_mm;
    return along;
  }

 private:
  cv::Mat1b image_;
};

/// Gray level of the printed sheet as a function of the position in the pad frame, whose X axis points up the page.
std::function<std::optional<double>(const Vector2d&)> Printed(const Raster& raster, const LandingPad& pad) {
  return [&raster, center = Vector2d(500.0 * pad.sheet_width_m, 500.0 * pad.sheet_length_m),
          half = Vector2d(0.5 * pad.sheet_length_m, 0.5 * pad.sheet_width_m)](
             const Vector2d& p_W) -> std::optional<double> {
    if ((p_W.cwiseAbs() - half).maxCoeff() > 0.0) return std::nullopt;
    return 25.0 + 190.0 / 255.0 * raster.At(center + 1000.0 * Vector2d(-p_W.y(), -p_W.x()));
  };
}

TEST(PadSheet, PrintsPadToScale) {
  const LandingPad pad;
  const Raster raster(pad);
  EXPECT_NEAR(raster.width_mm(), 210.0, 0.1);
  EXPECT_NEAR(raster.height_mm(), 297.0, 0.1);
  const Vector2d center(105.0, 148.5);
  for (int i = 0; i < 360; ++i) {
    const double angle = i * models::kPi / 180.0;
    const Vector2d outward(std::cos(angle), std::sin(angle));
    const Vector2d on_ring = center + 82.0 * outward;
    EXPECT_NEAR(82.0 + raster.InkEnd(on_ring, outward), 90.0, 0.05) << i;
    EXPECT_NEAR(82.0 - raster.InkEnd(on_ring, -outward), 74.0, 0.05) << i;
  }
  const Vector2d right(1.0, 0.0), down(0.0, 1.0);
  EXPECT_NEAR(raster.InkEnd(center, right), 28.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(center, -right), 28.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(center, down), 8.0, 0.05);
  const Vector2d stroke = center + 20.0 * right;
  EXPECT_NEAR(raster.InkEnd(stroke, down), 50.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(stroke, -down), 50.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(stroke + 20.0 * down, -right), 8.0, 0.05);
}

TEST(PadSheet, PrintsSolidRectangleWithoutSeam) {
  LandingPad pad;
  pad.h_stroke_m = 0.5 * pad.h_width_m;
  const Raster raster(pad);
  const Vector2d center(105.0, 148.5);
  EXPECT_NEAR(raster.InkEnd(center, {1.0, 0.0}), 28.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(center, {0.0, 1.0}), 50.0, 0.05);
  for (double x = -27.9; x < 27.9; x += 0.01) {  // The edge is gray, one pixel (0.04 mm) wide.
    EXPECT_LT(raster.At(center + Vector2d(x, 30.0)), 10.0) << x;
  }
}

TEST(PadSheet, PrintsMarkingsToScale) {
  LandingPad pad;
  pad.marks = {
      {.shape = models::PadMarking::Shape::kDisc, .center_m = {0.02, 0.05}, .diameter_m = 0.01},
      {.shape = models::PadMarking::Shape::kBar,
       .center_m = {-0.02, 0.05},
       .length_m = 0.02,
       .width_m = 0.004,
       .angle_deg = 30.0},
      {.shape = models::PadMarking::Shape::kBar, .center_m = {0.05, 0.02}, .length_m = 0.03, .width_m = 0.004}};
  const Raster raster(pad);
  const auto on_page = [](const Vector2d& p_W) { return Vector2d(105.0 - 1000.0 * p_W.y(), 148.5 - 1000.0 * p_W.x()); };
  const auto direction = [](double degrees) {
    const double angle = models::DegToRad(degrees);
    return Vector2d(-std::sin(angle), -std::cos(angle));
  };
  const Vector2d disc = on_page({0.02, 0.05}), bar = on_page({-0.02, 0.05}), over_stroke = on_page({0.05, 0.02});
  for (double degrees = 0.0; degrees < 360.0; degrees += 5.0) {
    EXPECT_NEAR(raster.InkEnd(disc, direction(degrees)), 5.0, 0.05) << degrees;
  }
  for (const double half_turn : {0.0, 180.0}) {
    EXPECT_NEAR(raster.InkEnd(bar, direction(30.0 + half_turn)), 10.0, 0.05);
    EXPECT_NEAR(raster.InkEnd(bar, direction(120.0 + half_turn)), 2.0, 0.05);
  }
  EXPECT_NEAR(raster.InkEnd(over_stroke, direction(0.0)), 15.0, 0.05) << "outside the stroke";
  EXPECT_NEAR(raster.InkEnd(over_stroke, direction(180.0)), 100.0, 0.05) << "along the stroke, which stays black";
}

TEST(PadSheet, HasRulerOf100Millimeters) {
  const Raster raster((LandingPad()));
  std::vector<double> ticks_mm;
  // Finds a row that only the centimeter ticks reach.
  double row_mm = 0.0;
  for (double y = 245.0; y < 290.0 && ticks_mm.size() < 11; y += 0.1) {
    ticks_mm.clear();
    for (double x = 5.0; x < 205.0; x += 0.01) {
      const bool is_falling_edge = raster.At({x, y}) < 200.0 && raster.At({x - 0.01, y}) >= 200.0;
      if (is_falling_edge) ticks_mm.push_back(x);
    }
    row_mm = y;
    if (ticks_mm.size() != 11) ticks_mm.clear();
  }
  ASSERT_EQ(ticks_mm.size(), 11u) << row_mm;
  for (std::size_t i = 1; i < ticks_mm.size(); ++i) EXPECT_NEAR(ticks_mm[i] - ticks_mm[i - 1], 10.0, 0.1);
  EXPECT_NEAR(ticks_mm.back() - ticks_mm.front(), 100.0, 0.1);
}

TEST(PadSheet, PrintedPadIsFoundByEstimator) {
  LandingPad large;
  large.ring_width_m = 0.008;
  large.h_height_m = 0.120;
  large.h_width_m = 0.070;
  large.h_stroke_m = 0.018;
  for (const LandingPad& pad : {LandingPad(), large}) {
    const Raster raster(pad);
    const estimator::EstimatorSetup setup{.camera = {}, .pad = pad, .X_BC = models::Vehicle().X_BC(), .time = {}};
    const Eigen::Isometry3d X_WC = tests::CameraAbovePad({0.05, -0.04, 0.5}, 0.3, 0.1, 0.7);
    const Eigen::Isometry3d X_WB = X_WC * setup.X_BC.inverse();
    models::RandomStream random(1, "tests.pad_sheet");
    tests::PadAppearance appearance{.noise_sigma = 3.0, .lens_blur_sigma_px = 0.5};
    appearance.paint = Printed(raster, pad);
    const models::Image image = tests::RenderPad(setup.camera, pad, X_WC, appearance, &random);
    const auto result = estimator::paper::PaperEstimator(setup).Estimate(image.View(), 0, tests::GravityIn(X_WB));
    ASSERT_TRUE(result.pose) << result.reason;
    EXPECT_LT((result.pose->X_WB.translation() - X_WB.translation()).norm(), 0.02);
    EXPECT_LT(models::RotationLog(result.pose->X_WB.linear().transpose() * X_WB.linear()).norm(), 0.06);
  }
}

TEST(PadSheet, EnlargesPageWhenRulerDoesNotFitOnSheet) {
  LandingPad small;
  small.outer_radius_m = 0.030;
  small.ring_width_m = 0.005;
  small.h_height_m = 0.034;
  small.h_width_m = 0.019;
  small.h_stroke_m = 0.005;
  small.sheet_length_m = small.sheet_width_m = 0.064;
  const Raster raster(small);
  EXPECT_GT(raster.width_mm(), 100.0);
  EXPECT_GT(raster.height_mm(), 64.0 + 20.0);
  const Vector2d center(0.5 * raster.width_mm(), 32.0);
  EXPECT_NEAR(27.5 + raster.InkEnd(center + Vector2d(27.5, 0.0), {1.0, 0.0}), 30.0, 0.05);
  EXPECT_NEAR(raster.InkEnd(center, {1.0, 0.0}), 9.5, 0.05);
}

TEST(PadSheet, WritesSvgOfSameSize) {
  const std::string svg = PadSheet({}, SheetFormat::kSvg);
  EXPECT_THAT(svg, testing::StartsWith("<?xml"));
  EXPECT_THAT(svg, testing::ContainsRegex("width=\"595\\.27.*pt\" height=\"841\\.8.*pt\""));
  EXPECT_THAT(svg, testing::HasSubstr(kPadSheetSignature));
  EXPECT_THAT(PadSheet({}, SheetFormat::kPdf), testing::HasSubstr(kPadSheetSignature));
}

TEST(PadSheet, ThrowsForInvalidPad) {
  LandingPad pad;
  pad.ring_width_m = 0.1;
  EXPECT_THROW(PadSheet(pad, SheetFormat::kPdf), InputError);
}

}  // namespace
}  // namespace touchdown::report
