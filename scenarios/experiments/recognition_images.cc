#include "scenarios/experiments/recognition_images.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>

#include "estimator/paper/binarize.h"
#include "estimator/paper/components.h"
#include "models/angles.h"
#include "scenarios/experiments/static_scene.h"
#include "scenarios/report/annotated_frame.h"
#include "scenarios/util/base64.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector3d;
using models::DegToRad;

/// Camera pose and image quality of an example view.
struct ViewSpec {
  double distance_m;  ///< From the center of the pad to the camera.
  double tilt_deg, direction_deg, yaw_deg;
  double off_u_px, off_v_px;  ///< Offset of the pad from the principal point.
  Vector3d v_m_s = Vector3d::Zero();
  double exposure_s = 0.004;
  double defocus_px = 0.0;
};

training::View ViewFrom(const ViewSpec& spec, const models::CameraModel& camera) {
  const double direction = DegToRad(spec.direction_deg);
  training::View view;
  view.X_WC.linear() =
      models::RotationExp(DegToRad(spec.tilt_deg) * Vector3d(std::cos(direction), std::sin(direction), 0.0)) *
      models::RotationFromTaitBryan({.roll = models::kPi, .yaw = DegToRad(spec.yaw_deg)});
  const Vector3d ray_C = camera.Ray({camera.cx_px + spec.off_u_px, camera.cy_px + spec.off_v_px}).value();
  view.X_WC.translation() = -spec.distance_m * (view.X_WC.linear() * ray_C);
  view.v_WC = spec.v_m_s;
  view.exposure_s = spec.exposure_s;
  view.defocus_px = spec.defocus_px;
  return view;
}

/// A random room. Captures views of it, and runs the estimator on them.
class ExampleRoom {
 public:
  ExampleRoom(const runner::Scenario& nominal, std::uint64_t seed)
      : nominal_(nominal), static_scene_(nominal, sim::MakeScene(nominal.scene, nominal.pad, seed), seed) {}

  struct Sample {
    models::Image image = {};
    estimator::FrameResult estimate = {};
  };

  Sample Capture(const ViewSpec& spec) {
    const training::View view = ViewFrom(spec, nominal_.camera.model);
    Sample sample{.image = static_scene_.Capture(view)};
    sample.estimate = static_scene_.Estimate(sample.image, DownInBody(view.X_WC * nominal_.vehicle.X_BC().inverse()));
    return sample;
  }

 private:
  const runner::Scenario& nominal_;
  StaticScene static_scene_;
};

cv::Mat3b Colored(models::Image& image) {
  cv::Mat3b colored;
  cv::cvtColor(cv::Mat1b(image.height, image.width, image.pixels.data()), colored, cv::COLOR_GRAY2BGR);
  return colored;
}

cv::Mat Grid(const std::vector<cv::Mat3b>& tiles, int columns) {
  constexpr int kGap = 6;
  std::vector<cv::Mat> rows;
  for (std::size_t i = 0; i < tiles.size(); i += static_cast<std::size_t>(columns)) {
    std::vector<cv::Mat> row;
    for (std::size_t k = i; k < std::min(tiles.size(), i + static_cast<std::size_t>(columns)); ++k) {
      cv::Mat framed;
      cv::copyMakeBorder(tiles[k], framed, 0, kGap, 0, kGap, cv::BORDER_CONSTANT, cv::Scalar::all(255));
      row.push_back(framed);
    }
    rows.emplace_back();
    cv::hconcat(row, rows.back());
  }
  cv::Mat grid;
  cv::vconcat(rows, grid);
  return grid;
}

/// CSV lines of the components of a view, with the columns of kComponentHead.
std::string ComponentLines(int view, const estimator::Overlay& overlay) {
  std::string lines;
  for (const auto& [box, role, name, probability] : overlay.boxes) {
    lines +=
        fmt::format("{},{},{},{},{},{},{:.4f}\n", view, box.u, box.v, box.width, box.height, name, probability.value());
  }
  return lines;
}
constexpr const char* kComponentHead = "view,u_px,v_px,width_px,height_px,class,probability\n";

/// CSV lines of the ellipses of a view in undistorted px, with the columns of kEllipseHead.
std::string EllipseLines(int view, const estimator::Overlay& overlay) {
  std::string lines;
  for (const estimator::Overlay::Ellipse& ellipse : overlay.ellipses) {
    lines +=
        fmt::format("{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", view, ellipse.name, ellipse.center.x(),
                    ellipse.center.y(), ellipse.semi_axes.x(), ellipse.semi_axes.y(), models::RadToDeg(ellipse.angle));
  }
  return lines;
}
constexpr const char* kEllipseHead = "view,ellipse,u_px,v_px,semi_major_px,semi_minor_px,angle_deg\n";

Json ImageJson(const std::string& name, const std::string& title, const std::string& caption, const cv::Mat& image,
               const std::string& csv) {
  constexpr int kQuality = 82;
  std::vector<unsigned char> jpeg;
  if (!cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality})) {
    throw std::runtime_error("an image of the report cannot be encoded as JPEG");
  }
  return {{"name", name},
          {"title", title},
          {"caption", caption},
          {"jpeg", util::Base64({jpeg.begin(), jpeg.end()})},
          {"csv", csv}};
}

/// Fig. 2: the image, its dark pixels, its components and their classes.
Json Stages(const runner::Scenario& nominal) {
  ExampleRoom room(nominal, 4);
  ExampleRoom::Sample sample = room.Capture({.distance_m = 1.0,
                                             .tilt_deg = 12.0,
                                             .direction_deg = 40.0,
                                             .yaw_deg = 25.0,
                                             .off_u_px = -60.0,
                                             .off_v_px = 30.0});
  models::Image dark = estimator::paper::Binarize(sample.image.View());
  const estimator::paper::ComponentSet set = estimator::paper::ExtractComponents(dark.View());
  cv::Mat3b boxes = Colored(sample.image);
  for (const estimator::paper::Component& each : set.components) {
    cv::rectangle(boxes, cv::Rect(each.u, each.v, each.width, each.height), {0, 170, 240});
  }
  estimator::Overlay labels;
  labels.boxes = sample.estimate.overlay.boxes;
  const cv::Mat3b classified =
      report::AnnotateFrame(sample.image.View(), nominal.camera.model,
                            {.overlay = labels, .pad_px = sample.estimate.pad_px, .X_WC = std::nullopt});
  return ImageJson("fig_2_stages", "Fig. 2: the steps of the recognition",
                   "The image, its dark pixels, the connected components, and their classes: green for circles, blue "
                   "for the letter H, red for others. The orange cross is the pad.",
                   Grid({Colored(sample.image), Colored(dark), boxes, classified}, 2),
                   kComponentHead + ComponentLines(1, sample.estimate.overlay));
}

/// Fig. 4: posters, single rings and letters, strong perspective, blur.
Json ClutteredViews(const runner::Scenario& nominal) {
  const std::array<ViewSpec, 6> specs = {{{.distance_m = 0.45,
                                           .tilt_deg = 5.0,
                                           .direction_deg = 0.0,
                                           .yaw_deg = 10.0,
                                           .off_u_px = 20.0,
                                           .off_v_px = -15.0},
                                          {.distance_m = 1.2,
                                           .tilt_deg = 42.0,
                                           .direction_deg = 70.0,
                                           .yaw_deg = -30.0,
                                           .off_u_px = 30.0,
                                           .off_v_px = 40.0},
                                          {.distance_m = 1.9,
                                           .tilt_deg = 15.0,
                                           .direction_deg = 190.0,
                                           .yaw_deg = 70.0,
                                           .off_u_px = -90.0,
                                           .off_v_px = 60.0},
                                          {.distance_m = 0.9,
                                           .tilt_deg = 48.0,
                                           .direction_deg = -60.0,
                                           .yaw_deg = 45.0,
                                           .off_u_px = 0.0,
                                           .off_v_px = -60.0},
                                          {.distance_m = 1.0,
                                           .tilt_deg = 18.0,
                                           .direction_deg = 120.0,
                                           .yaw_deg = -60.0,
                                           .off_u_px = 120.0,
                                           .off_v_px = -60.0,
                                           .v_m_s = {1.0, 0.6, 0.0},
                                           .exposure_s = 0.010},
                                          {.distance_m = 1.4,
                                           .tilt_deg = 30.0,
                                           .direction_deg = 10.0,
                                           .yaw_deg = 0.0,
                                           .off_u_px = -40.0,
                                           .off_v_px = 90.0,
                                           .defocus_px = 1.3}}};
  std::vector<cv::Mat3b> tiles;
  std::string csv = kComponentHead;
  std::uint64_t seed = 11;
  for (const ViewSpec& spec : specs) {
    ExampleRoom room(nominal, seed++);
    ExampleRoom::Sample sample = room.Capture(spec);
    csv += ComponentLines(static_cast<int>(tiles.size()) + 1, sample.estimate.overlay);
    tiles.push_back(report::AnnotateFrame(
        sample.image.View(), nominal.camera.model,
        {.overlay = sample.estimate.overlay, .pad_px = sample.estimate.pad_px, .X_WC = std::nullopt}));
  }
  return ImageJson("fig_4_clutter", "Fig. 4: recognition in clutter",
                   "Views of six rooms. The fifth view has motion blur, and the sixth is out of focus. A single circle "
                   "or a single letter is not a pad.",
                   Grid(tiles, 3), csv);
}

/// Fig. 5: image patches around the pad, and the ellipses fitted to its contours.
Json FittedPatches(const runner::Scenario& nominal) {
  constexpr int kSide = 200;
  std::vector<cv::Mat3b> patches, fitted;
  std::string csv = kEllipseHead;
  ExampleRoom room(nominal, 21);
  for (int i = 0; i < 8; ++i) {
    const bool moves = i % 3 == 2;
    const ViewSpec spec{.distance_m = 0.5 + 0.12 * i,
                        .tilt_deg = 6.0 * i,
                        .direction_deg = 77.0 * i,
                        .yaw_deg = -80.0 + 23.0 * i,
                        .off_u_px = 15.0 * (i % 4) - 20.0,
                        .off_v_px = 20.0 - 12.0 * (i % 3),
                        .v_m_s = moves ? Vector3d(0.9, -0.7, 0.0) : Vector3d::Zero(),
                        .exposure_s = moves ? 0.012 : 0.004};
    ExampleRoom::Sample sample = room.Capture(spec);
    if (!sample.estimate.ring_box) continue;
    const estimator::PixelBox& box = *sample.estimate.ring_box;
    const int side = std::max(box.width, box.height) * 4 / 3;
    const cv::Rect around = cv::Rect(box.u + (box.width - side) / 2, box.v + (box.height - side) / 2, side, side) &
                            cv::Rect(0, 0, sample.image.width, sample.image.height);
    estimator::Overlay ellipses = sample.estimate.overlay;
    ellipses.boxes.clear();
    const cv::Mat3b annotated = report::AnnotateFrame(
        sample.image.View(), nominal.camera.model, {.overlay = ellipses, .pad_px = std::nullopt, .X_WC = std::nullopt});
    const auto tile = [&](const cv::Mat3b& full) {
      cv::Mat3b scaled;
      cv::resize(full(around), scaled, {kSide, kSide}, 0, 0, cv::INTER_CUBIC);
      return scaled;
    };
    csv += EllipseLines(static_cast<int>(patches.size()) + 1, sample.estimate.overlay);
    patches.push_back(tile(Colored(sample.image)));
    fitted.push_back(tile(annotated));
  }
  const int columns = static_cast<int>(patches.size());
  patches.insert(patches.end(), fitted.begin(), fitted.end());
  return ImageJson("fig_5_ellipses", "Fig. 5: fitted ellipses",
                   "Patches of the pad from various perspectives, every third with motion blur. Below them: the fitted "
                   "ellipses of both edges of the ring and of the H, with their axes.",
                   Grid(patches, columns), csv);
}

}  // namespace

Json MakeRecognitionImages(const runner::Scenario& nominal) {
  return Json::array({Stages(nominal), ClutteredViews(nominal), FittedPatches(nominal)});
}

std::vector<report::ReportImage> ImagesFromJson(const Json& images) {
  std::vector<report::ReportImage> result;
  for (const Json& each : images) {
    result.push_back({each.at("name").get<std::string>(), each.at("title").get<std::string>(),
                      each.at("caption").get<std::string>(), util::FromBase64(each.at("jpeg").get<std::string>()),
                      each.at("csv").get<std::string>()});
  }
  return result;
}

}  // namespace touchdown::experiments
