// Recognition rates of the estimator `paper` on synthetic photographs.
//
// Usage: photograph_study [--pads N] [--look-alikes N] [--seed FIRST] [--save FOLDER] [--sheet FILE]
// Prints a table for each factor. --look-alikes is the number of distractors. --save writes the photographs with wrong
// results as images, --sheet writes the first photographs side by side to one image.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "tests/support/photograph_score.h"

namespace {

using namespace touchdown;
using tests::Photograph;

struct Count {
  int right = 0, all = 0;
  std::map<std::string, int> failures;
};

std::string Bin(double value, const std::vector<double>& limits) {
  char text[64];
  std::size_t i = 0;
  while (i + 2 < limits.size() && value >= limits[i + 1]) ++i;
  std::snprintf(text, sizeof text, "%5.2f .. %5.2f", limits[i], limits[i + 1]);
  return text;
}

std::map<std::string, std::string> FactorsOf(const Photograph& photo) {
  const auto& c = photo.conditions;
  const auto& pad = photo.pad;
  return {{"size", Bin(c.size_fraction, {0.03, 0.1, 0.2, 0.4, 0.6, 0.9})},
          {"obliquity", Bin(c.obliquity_deg, {0, 20, 40, 50, 60})},
          {"curl", Bin(c.curl, {0, 1e-9, 0.1, 0.3})},
          {"blur", Bin(c.blur_fraction, {0, 0.2, 0.4, 0.7, 2.0})},
          {"glare", Bin(c.glare, {0, 1e-9, 0.4, 1.0})},
          {"shadow", Bin(c.shadow, {0.2, 0.5, 0.999, 1.0})},
          {"exposure", Bin(c.exposure, {0.1, 0.3, 1.0, 1.5})},
          {"noise", Bin(c.noise_sigma, {0, 4, 10})},
          {"ring", Bin(pad.ring_width_m / pad.outer_radius_m, {0.05, 0.1, 0.2, 0.3})},
          {"h", Bin(std::hypot(pad.h_height_m, pad.h_width_m) / (2.0 * pad.inner_radius_m()), {0.35, 0.55, 0.7, 0.9})},
          {"aspect", Bin(pad.h_width_m / pad.h_height_m, {0.45, 0.6, 0.75, 0.86})},
          {"marks", c.marks},
          {"floor", c.floor},
          {"image", std::to_string(photo.camera.width_px) + "x" + std::to_string(photo.camera.height_px)}};
}

cv::Mat3b ToColor(const Photograph& photo) {
  cv::Mat1b gray(photo.image.height, photo.image.width, const_cast<std::uint8_t*>(photo.image.pixels.data()));
  cv::Mat3b canvas;
  cv::cvtColor(gray, canvas, cv::COLOR_GRAY2BGR);
  return canvas;
}

void Save(const std::string& folder, std::uint64_t seed, const Photograph& photo, const tests::PhotoScore& score) {
  cv::Mat3b canvas = ToColor(photo);
  for (const auto& c : score.estimate.overlay.boxes) {
    const cv::Scalar color = c.name == "circle" ? cv::Scalar(0, 200, 0)
                             : c.name == "h"    ? cv::Scalar(255, 80, 0)
                                                : cv::Scalar(0, 0, 230);
    cv::rectangle(canvas, cv::Rect(c.box.u, c.box.v, c.box.width, c.box.height), color);
  }
  const std::string status(estimator::ReasonOrStatus(score.estimate.status, score.estimate.reason));
  std::string subject = photo.subject;
  std::replace(subject.begin(), subject.end(), ' ', '_');
  cv::imwrite(folder + "/" + subject + "_" + std::to_string(seed) + "_" + status + ".png", canvas);
}

void DrawSheet(const std::string& path, const std::function<Photograph(int)>& take, int count) {
  constexpr int kColumns = 6, kSide = 300;
  cv::Mat3b sheet((count + kColumns - 1) / kColumns * kSide, kColumns * kSide, cv::Vec3b(255, 255, 255));
  for (int i = 0; i < count; ++i) {
    const Photograph photo = take(i);
    cv::Mat3b canvas = ToColor(photo);
    const double scale = (kSide - 6.0) / std::max(canvas.cols, canvas.rows);
    cv::resize(canvas, canvas, {}, scale, scale, cv::INTER_AREA);
    cv::putText(canvas, photo.subject, {4, 14}, cv::FONT_HERSHEY_SIMPLEX, 0.45, {0, 0, 255}, 1, cv::LINE_AA);
    canvas.copyTo(sheet(cv::Rect(i % kColumns * kSide, i / kColumns * kSide, canvas.cols, canvas.rows)));
  }
  cv::imwrite(path, sheet);
}

void Print(const char* title, const std::map<std::string, std::map<std::string, Count>>& table) {
  std::printf("\n%s\n", title);
  for (const auto& [factor, rows] : table) {
    for (const auto& [value, count] : rows) {
      std::printf("%-10s %-24s %4d of %4d  %6.2f %%", factor.c_str(), value.c_str(), count.right, count.all,
                  100.0 * count.right / count.all);
      for (const auto& [status, number] : count.failures) std::printf("  %s %d", status.c_str(), number);
      std::printf("\n");
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  std::map<std::string, std::string> options{
      {"--pads", "300"}, {"--look-alikes", "600"}, {"--seed", "1"}, {"--save", ""}, {"--sheet", ""}};
  for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
  const int pads = std::stoi(options["--pads"]), distractors = std::stoi(options["--look-alikes"]);
  const std::uint64_t first = std::stoull(options["--seed"]);
  const std::string folder = options["--save"];
  if (!options["--sheet"].empty()) {
    const auto take = [&](int i) {
      return i < pads ? tests::PhotographPad(first + i) : tests::PhotographDistractor(first + i - pads);
    };
    DrawSheet(options["--sheet"], take, pads + distractors);
    return 0;
  }

  std::map<std::string, std::map<std::string, Count>> by_factor, by_kind;
  std::vector<double> distance_errors;
  for (int i = 0; i < pads; ++i) {
    const Photograph photo = tests::PhotographPad(first + i);
    const tests::PhotoScore score = tests::Score(photo);
    std::string failure(estimator::ReasonOrStatus(score.estimate.status, score.estimate.reason));
    if (score.estimate.pose) failure = "wrong_place";
    auto factors = FactorsOf(photo);
    factors["all"] = "";
    for (const auto& [factor, value] : factors) {
      Count& count = by_factor[factor][value];
      ++count.all;
      score.found ? ++count.right : ++count.failures[failure];
    }
    if (score.found) distance_errors.push_back(score.distance_error);
    if (!score.found && !folder.empty()) Save(folder, first + i, photo, score);
  }
  for (int i = 0; i < distractors; ++i) {
    const Photograph photo = tests::PhotographDistractor(first + i);
    const tests::PhotoScore score = tests::Score(photo);
    for (const std::string& kind : {photo.subject, std::string("~ all")}) {
      Count& count = by_kind[""][kind];
      ++count.all;
      score.reports_pad
          ? ++count.failures[std::string(estimator::ReasonOrStatus(score.estimate.status, score.estimate.reason))]
          : ++count.right;
    }
    if (score.reports_pad && !folder.empty()) Save(folder, first + i, photo, score);
  }
  Print("Pads found", by_factor);
  Print("Distractors rejected", by_kind);
  std::sort(distance_errors.begin(), distance_errors.end());
  if (!distance_errors.empty()) {
    std::printf("\nDistance, relative error: median %.4f, 95 %% %.4f\n", distance_errors[distance_errors.size() / 2],
                distance_errors[distance_errors.size() * 95 / 100]);
  }
  return 0;
}
