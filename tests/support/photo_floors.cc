#include "tests/support/photo_floors.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "models/angles.h"

namespace touchdown::tests {
namespace {

using models::kPi;
using models::RandomStream;

constexpr int kSide = kFloorSide_px;

/// Noise of unit variance that is smooth over about `scale_x` and `scale_y` px.
cv::Mat1f Noise(double scale_x, double scale_y, RandomStream& random) {
  const cv::Size coarse(std::max(4, static_cast<int>(kSide / scale_x)), std::max(4, static_cast<int>(kSide / scale_y)));
  cv::Mat1f noise(coarse), fine;
  cv::RNG rng(random.Bits());
  rng.fill(noise, cv::RNG::NORMAL, 0.0, 1.0);
  cv::resize(noise, fine, {kSide, kSide}, 0, 0, cv::INTER_CUBIC);
  return fine;
}

cv::Mat1b Gray(const cv::Mat1f& values) {
  cv::Mat1b gray;
  values.convertTo(gray, CV_8U);
  return gray;
}

/// Draws a position of an object with radius `reach` outside the free disc.
cv::Point DrawPosition(double free_radius, double reach, RandomStream& random) {
  while (true) {
    const cv::Point2d p(random.Uniform(0.0, kSide), random.Uniform(0.0, kSide));
    if (cv::norm(p - cv::Point2d(kSide / 2.0, kSide / 2.0)) > free_radius + reach) return p;
  }
}

cv::Mat1b Wood(RandomStream& random) {
  cv::Mat1f floor = random.Uniform(70.0, 170.0) + 12.0 * Noise(300.0, 6.0, random) + 5.0 * Noise(60.0, 2.0, random);
  const int planks = random.UniformInt(3, 9);
  for (int i = 0; i < planks; ++i) {
    const int row = kSide * i / planks;
    cv::line(floor, {0, row}, {kSide, row}, cv::Scalar(40), random.UniformInt(1, 4));
    const int column = random.UniformInt(0, kSide);
    cv::line(floor, {column, row}, {column, row + kSide / planks}, cv::Scalar(45), 2);
    floor.rowRange(row, std::min(kSide, row + kSide / planks)) += random.Uniform(-12.0, 12.0);
  }
  return Gray(floor);
}

cv::Mat1b Tiles(RandomStream& random) {
  cv::Mat1f floor = random.Uniform(110.0, 220.0) + 4.0 * Noise(40.0, 40.0, random);
  const int step = kSide / random.UniformInt(3, 12), grout = random.UniformInt(3, 14);
  const double gray = random.Uniform(30.0, 150.0);
  const bool octagons = random.Bernoulli(0.3);
  for (int at = step / 2; at < kSide + step; at += step) {
    cv::line(floor, {at, 0}, {at, kSide}, cv::Scalar(gray), grout, cv::LINE_AA);
    cv::line(floor, {0, at}, {kSide, at}, cv::Scalar(gray), grout, cv::LINE_AA);
    for (int other = step / 2; octagons && other < kSide; other += step) {
      cv::ellipse(floor, {at, other}, {step / 5, step / 5}, 45, 0, 360, cv::Scalar(0.5 * gray), cv::FILLED,
                  cv::LINE_AA);
    }
  }
  return Gray(floor);
}

cv::Mat1b Carpet(RandomStream& random) {
  return Gray(random.Uniform(50.0, 160.0) + random.Uniform(6.0, 22.0) * Noise(2.0, 2.0, random) +
              7.0 * Noise(25.0, 25.0, random));
}

cv::Mat1b Concrete(RandomStream& random) {
  cv::Mat1f floor = random.Uniform(90.0, 190.0) + 7.0 * Noise(120.0, 120.0, random) + 6.0 * Noise(8.0, 8.0, random) +
                    5.0 * Noise(1.5, 1.5, random);
  cv::Point2d at(random.Uniform(0.0, kSide), 0.0);
  for (double heading = random.Uniform(0.8, 2.2); at.y < kSide && at.y >= 0.0;) {
    heading = std::clamp(heading + 0.3 * random.Normal(), 0.4, 2.7);
    const cv::Point2d next = at + 20.0 * cv::Point2d(std::cos(heading), std::sin(heading));
    cv::line(floor, at, next, cv::Scalar(50), 2, cv::LINE_AA);
    at = next;
  }
  return Gray(floor);
}

cv::Mat1b Plain(RandomStream& random) { return Gray(random.Uniform(25.0, 235.0) + 2.0 * Noise(200.0, 200.0, random)); }

void AddPage(cv::Mat1b& floor, const cv::Point& center, double height, double yaw, RandomStream& random) {
  cv::Mat1b page(static_cast<int>(height), static_cast<int>(0.71 * height),
                 static_cast<std::uint8_t>(random.UniformInt(195, 235)));
  const int line = random.UniformInt(9, 26);
  static const std::vector<std::string> kWords = {"the", "H",   "house",  "HALF", "of",
                                                  "low", "008", "flight", "Hub",  "O"};
  for (int row = line; row < page.rows - line; row += line) {
    for (int column = line; column < page.cols - 3 * line;) {
      const auto& word = kWords[static_cast<std::size_t>(random.UniformInt(0, 9))];
      const double scale = 0.45 * line / 21.0;
      cv::putText(page, word, {column, row}, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(50), 1, cv::LINE_AA);
      column += static_cast<int>(cv::getTextSize(word, cv::FONT_HERSHEY_SIMPLEX, scale, 1, nullptr).width + 0.4 * line);
    }
  }
  cv::Mat rotation = cv::getRotationMatrix2D({page.cols / 2.0F, page.rows / 2.0F}, models::RadToDeg(yaw), 1.0);
  rotation.at<double>(0, 2) += center.x - page.cols / 2.0;
  rotation.at<double>(1, 2) += center.y - page.rows / 2.0;
  cv::warpAffine(page, floor, rotation, floor.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
}

void AddCup(cv::Mat1b& floor, const cv::Point& center, int radius, RandomStream& random) {
  const bool dark = random.Bernoulli(0.5);
  const cv::Scalar rim(dark ? 30 : 225), inside(dark ? 200 : 40), saucer(random.UniformInt(150, 240));
  if (random.Bernoulli(0.5)) {
    cv::circle(floor, center, radius * 8 / 5, saucer, cv::FILLED, cv::LINE_AA);
    cv::circle(floor, center, radius * 7 / 5, saucer * 0.8, 2, cv::LINE_AA);
  }
  const double angle = random.Uniform(0.0, 2.0 * kPi);
  const cv::Point handle(center.x + static_cast<int>(1.3 * radius * std::cos(angle)),
                         center.y + static_cast<int>(1.3 * radius * std::sin(angle)));
  cv::line(floor, center, handle, rim, std::max(2, radius / 3), cv::LINE_AA);
  cv::circle(floor, center, radius, rim, cv::FILLED, cv::LINE_AA);
  cv::circle(floor, center, radius * random.UniformInt(72, 92) / 100, inside, cv::FILLED, cv::LINE_AA);
  if (random.Bernoulli(0.4)) cv::circle(floor, center, radius / 3, rim * 0.7, std::max(1, radius / 10), cv::LINE_AA);
}

void AddKeyboard(cv::Mat1b& floor, const cv::Point& corner, int key, RandomStream& random) {
  const bool dark = random.Bernoulli(0.6);
  cv::rectangle(floor, cv::Rect(corner.x - key / 2, corner.y - key / 2, 13 * key, 5 * key), cv::Scalar(dark ? 45 : 200),
                cv::FILLED);
  static const std::string kKeys = "QWERTZUIOPASDFGHJKLYXCVBNM0HO8";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 12; ++column) {
      const cv::Rect cap(corner.x + column * key, corner.y + row * key, key * 4 / 5, key * 4 / 5);
      cv::rectangle(floor, cap, cv::Scalar(dark ? 25 : 235), cv::FILLED);
      cv::putText(floor, std::string(1, kKeys[static_cast<std::size_t>(random.UniformInt(0, 29))]),
                  {cap.x + key / 5, cap.y + key / 2}, cv::FONT_HERSHEY_SIMPLEX, key / 60.0, cv::Scalar(dark ? 210 : 30),
                  std::max(1, key / 24), cv::LINE_AA);
    }
  }
}

void AddPen(cv::Mat1b& floor, const cv::Point& at, RandomStream& random) {
  const double yaw = random.Uniform(0.0, 2.0 * kPi), length = random.Uniform(60.0, 130.0);
  const cv::Point tip(at.x + static_cast<int>(length * std::cos(yaw)), at.y + static_cast<int>(length * std::sin(yaw)));
  const int width = random.UniformInt(5, 10);
  cv::line(floor, at, tip, cv::Scalar(random.UniformInt(15, 240)), width, cv::LINE_AA);
  cv::circle(floor, tip, width / 3, cv::Scalar(20), cv::FILLED, cv::LINE_AA);
}

void AddCable(cv::Mat1b& floor, double free_radius, RandomStream& random) {
  const cv::Point2d middle(kSide / 2.0, kSide / 2.0);
  cv::Point2d at(0.0, random.Uniform(0.0, kSide));
  const cv::Scalar gray(random.UniformInt(10, 80));
  const int width = random.UniformInt(4, 9);
  double heading = random.Uniform(-0.7, 0.7);
  for (int i = 0; i < 160 && at.x < kSide; ++i) {
    heading = 0.97 * heading + 0.15 * random.Normal();
    const cv::Point2d next = at + 10.0 * cv::Point2d(std::cos(heading), std::sin(heading));
    if (cv::norm(next - middle) > free_radius + 10.0) cv::line(floor, at, next, gray, width, cv::LINE_AA);
    at = next;
  }
}

cv::Mat1b Page(double free_radius, RandomStream& random) {
  cv::Mat1b floor = Plain(random);
  for (int i = 0; i < 12; ++i) {
    AddPage(floor, DrawPosition(0.6 * free_radius, 0.0, random), random.Uniform(300.0, 600.0),
            random.Uniform(-kPi, kPi), random);
  }
  return floor;
}

cv::Mat1b Cups(double free_radius, RandomStream& random) {
  cv::Mat1b floor = random.Bernoulli(0.5) ? Wood(random) : Plain(random);
  for (int i = 0; i < 12; ++i) {
    const int radius = random.UniformInt(20, 90);
    AddCup(floor, DrawPosition(free_radius, 1.7 * radius, random), radius, random);
  }
  for (int i = 0; i < 10; ++i) {
    const int radius = random.UniformInt(8, 20);
    const cv::Point at = DrawPosition(free_radius, radius, random);
    cv::circle(floor, at, radius, cv::Scalar(random.UniformInt(60, 200)), cv::FILLED, cv::LINE_AA);
    cv::circle(floor, at, radius * 4 / 5, cv::Scalar(random.UniformInt(20, 120)), std::max(1, radius / 8), cv::LINE_AA);
  }
  return floor;
}

cv::Mat1b Desk(double free_radius, RandomStream& random) {
  cv::Mat1b floor = random.Bernoulli(0.6) ? Wood(random) : Plain(random);
  for (int i = 0; i < 4; ++i) {
    const double height = random.Uniform(150.0, 350.0);
    AddPage(floor, DrawPosition(free_radius, 0.2 * height, random), height, random.Uniform(-kPi, kPi), random);
  }
  for (int i = 0; i < 5; ++i) {  // Books, boxes, telephones.
    const cv::Point at = DrawPosition(free_radius, 60.0, random);
    const cv::RotatedRect box(
        at, cv::Size2f(static_cast<float>(random.Uniform(60, 160)), static_cast<float>(random.Uniform(80, 220))),
        static_cast<float>(random.Uniform(0.0, 180.0)));
    cv::Point2f corners[4];
    box.points(corners);
    std::vector<cv::Point> outline(corners, corners + 4);
    cv::fillConvexPoly(floor, outline, cv::Scalar(random.UniformInt(15, 235)), cv::LINE_AA);
    cv::polylines(floor, outline, true, cv::Scalar(random.UniformInt(15, 80)), 3, cv::LINE_AA);
  }
  AddKeyboard(floor, DrawPosition(free_radius, 100.0, random), random.UniformInt(22, 44), random);
  for (int i = 0; i < 3; ++i) {
    const int radius = random.UniformInt(25, 60);
    AddCup(floor, DrawPosition(free_radius, 1.7 * radius, random), radius, random);
  }
  for (int i = 0; i < 6; ++i) AddPen(floor, DrawPosition(free_radius, 60.0, random), random);
  for (int i = 0; i < 3; ++i) AddCable(floor, free_radius, random);
  return floor;
}

}  // namespace

const std::vector<std::string>& FloorKinds() {
  static const std::vector<std::string> kinds = {"wood",  "tiles", "carpet", "concrete",
                                                 "plain", "page",  "desk",   "cups"};
  return kinds;
}

cv::Mat1b DrawFloor(const std::string& kind, double free_radius_px, RandomStream& random) {
  if (kind == "wood") return Wood(random);
  if (kind == "tiles") return Tiles(random);
  if (kind == "carpet") return Carpet(random);
  if (kind == "concrete") return Concrete(random);
  if (kind == "page") return Page(free_radius_px, random);
  if (kind == "desk") return Desk(free_radius_px, random);
  if (kind == "cups") return Cups(free_radius_px, random);
  return Plain(random);
}

}  // namespace touchdown::tests
