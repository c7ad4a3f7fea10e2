#include "scenarios/experiments/recognition_pictures.h"

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
#include "scenarios/experiments/still_room.h"
#include "scenarios/report/annotated_frame.h"
#include "scenarios/util/base64.h"

namespace touchdown::experiments {
namespace {

using Eigen::Vector3d;
using models::DegToRad;

/// From where a picture is taken, and how well.
struct Look {
  double distance_m;  ///< From the pad's center.
  double tilt_deg, direction_deg, yaw_deg;
  double off_u_px, off_v_px;  ///< Of the pad from the image's middle.
  Vector3d v_m_s = Vector3d::Zero();
  double exposure_s = 0.004;
  double defocus_px = 0.0;
};

training::View ViewOf(const Look& look, const models::CameraModel& camera) {
  const double direction = DegToRad(look.direction_deg);
  training::View view;
  view.X_WC.linear() =
      models::RotationExp(DegToRad(look.tilt_deg) * Vector3d(std::cos(direction), std::sin(direction), 0.0)) *
      models::RotationFromTaitBryan({.roll = models::kPi, .yaw = DegToRad(look.yaw_deg)});
  const Vector3d ray_C = camera.Ray({camera.cx_px + look.off_u_px, camera.cy_px + look.off_v_px}).value();
  view.X_WC.translation() = -look.distance_m * (view.X_WC.linear() * ray_C);
  view.v_WC = look.v_m_s;
  view.exposure_s = look.exposure_s;
  view.defocus_px = look.defocus_px;
  return view;
}

/// A room, and the estimator that looks at pictures of it.
class Studio {
 public:
  Studio(const runner::Scenario& nominal, std::uint64_t seed)
      : nominal_(nominal), room_(nominal, sim::MakeScene(nominal.scene, nominal.pad, seed), seed) {}

  struct Taken {
    models::Image image = {};
    estimator::FrameResult seen = {};
  };

  Taken Take(const Look& look) {
    const training::View view = ViewOf(look, nominal_.camera.model);
    Taken taken{.image = room_.Take(view)};
    taken.seen = room_.Estimate(taken.image, DownIn(view.X_WC * nominal_.vehicle.X_BC().inverse()));
    return taken;
  }

 private:
  const runner::Scenario& nominal_;
  StillRoom room_;
};

cv::Mat3b Colored(models::Image& image) {
  cv::Mat3b picture;
  cv::cvtColor(cv::Mat1b(image.height, image.width, image.pixels.data()), picture, cv::COLOR_GRAY2BGR);
  return picture;
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

/// A line for each component of a view.
std::string ComponentLines(int view, const estimator::Overlay& overlay) {
  std::string lines;
  for (const auto& [box, role, name, probability] : overlay.boxes) {
    lines +=
        fmt::format("{},{},{},{},{},{},{:.4f}\n", view, box.u, box.v, box.width, box.height, name, probability.value());
  }
  return lines;
}
constexpr const char* kComponentHead = "view,u_px,v_px,width_px,height_px,class,probability\n";

/// A line for each ellipse of a view, undistorted px.
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

Json PictureJson(const std::string& name, const std::string& title, const std::string& caption, const cv::Mat& picture,
                 const std::string& csv) {
  constexpr int kQuality = 82;
  std::vector<unsigned char> jpeg;
  if (!cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality})) {
    throw std::runtime_error("a picture cannot be encoded as JPEG");
  }
  return {{"name", name},
          {"title", title},
          {"caption", caption},
          {"jpeg", util::Base64({jpeg.begin(), jpeg.end()})},
          {"csv", csv}};
}

/// Fig. 2: the picture, its dark pixels, its components, what they are.
Json Stages(const runner::Scenario& nominal) {
  Studio studio(nominal, 4);
  Studio::Taken taken = studio.Take({.distance_m = 1.0,
                                     .tilt_deg = 12.0,
                                     .direction_deg = 40.0,
                                     .yaw_deg = 25.0,
                                     .off_u_px = -60.0,
                                     .off_v_px = 30.0});
  models::Image dark = estimator::paper::Binarize(taken.image.View());
  const estimator::paper::ComponentSet set = estimator::paper::ExtractComponents(dark.View());
  cv::Mat3b boxes = Colored(taken.image);
  for (const estimator::paper::Component& each : set.components) {
    cv::rectangle(boxes, cv::Rect(each.u, each.v, each.width, each.height), {0, 170, 240});
  }
  estimator::Overlay labels;
  labels.boxes = taken.seen.overlay.boxes;
  const cv::Mat3b classified = report::AnnotateFrame(
      taken.image.View(), nominal.camera.model, {.overlay = labels, .pad_px = taken.seen.pad_px, .X_WC = std::nullopt});
  return PictureJson("fig_2_stages", "Fig. 2: the steps of the recognition",
                     "The image, its dark pixels, the connected components, and their classes: circles green, letters "
                     "H blue, others red, the pad an orange cross.",
                     Grid({Colored(taken.image), Colored(dark), boxes, classified}, 2),
                     kComponentHead + ComponentLines(1, taken.seen.overlay));
}

/// Fig. 4: posters, lone rings and letters, strong perspective, blur.
Json ClutteredViews(const runner::Scenario& nominal) {
  const std::array<Look, 6> looks = {{{.distance_m = 0.45,
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
  for (const Look& look : looks) {
    Studio studio(nominal, seed++);
    Studio::Taken taken = studio.Take(look);
    csv += ComponentLines(static_cast<int>(tiles.size()) + 1, taken.seen.overlay);
    tiles.push_back(
        report::AnnotateFrame(taken.image.View(), nominal.camera.model,
                              {.overlay = taken.seen.overlay, .pad_px = taken.seen.pad_px, .X_WC = std::nullopt}));
  }
  return PictureJson("fig_4_clutter", "Fig. 4: recognition in clutter",
                     "Six rooms; the fifth view is blurred by motion, the sixth out of focus. Circles and letters that "
                     "are recognized by themselves are no pad.",
                     Grid(tiles, 3), csv);
}

/// Fig. 5: the patch around the pad, and the ellipses fitted to its contours.
Json FittedPatches(const runner::Scenario& nominal) {
  constexpr int kSide = 200;
  std::vector<cv::Mat3b> patches, fitted;
  std::string csv = kEllipseHead;
  Studio studio(nominal, 21);
  for (int i = 0; i < 8; ++i) {
    const bool moves = i % 3 == 2;
    const Look look{.distance_m = 0.5 + 0.12 * i,
                    .tilt_deg = 6.0 * i,
                    .direction_deg = 77.0 * i,
                    .yaw_deg = -80.0 + 23.0 * i,
                    .off_u_px = 15.0 * (i % 4) - 20.0,
                    .off_v_px = 20.0 - 12.0 * (i % 3),
                    .v_m_s = moves ? Vector3d(0.9, -0.7, 0.0) : Vector3d::Zero(),
                    .exposure_s = moves ? 0.012 : 0.004};
    Studio::Taken taken = studio.Take(look);
    if (!taken.seen.ring_box) continue;
    const estimator::PixelBox& box = *taken.seen.ring_box;
    const int side = std::max(box.width, box.height) * 4 / 3;
    const cv::Rect around = cv::Rect(box.u + (box.width - side) / 2, box.v + (box.height - side) / 2, side, side) &
                            cv::Rect(0, 0, taken.image.width, taken.image.height);
    estimator::Overlay ellipses = taken.seen.overlay;
    ellipses.boxes.clear();
    const cv::Mat3b drawn = report::AnnotateFrame(taken.image.View(), nominal.camera.model,
                                                  {.overlay = ellipses, .pad_px = std::nullopt, .X_WC = std::nullopt});
    const auto tile = [&](const cv::Mat3b& whole) {
      cv::Mat3b scaled;
      cv::resize(whole(around), scaled, {kSide, kSide}, 0, 0, cv::INTER_CUBIC);
      return scaled;
    };
    csv += EllipseLines(static_cast<int>(patches.size()) + 1, taken.seen.overlay);
    patches.push_back(tile(Colored(taken.image)));
    fitted.push_back(tile(drawn));
  }
  const int columns = static_cast<int>(patches.size());
  patches.insert(patches.end(), fitted.begin(), fitted.end());
  return PictureJson("fig_5_ellipses", "Fig. 5: fitted ellipses",
                     "Patches of the pad from various perspectives, every third blurred by motion, and below them the "
                     "ellipses of both of the ring's edges and of the H, with their axes.",
                     Grid(patches, columns), csv);
}

}  // namespace

Json TakeRecognitionPictures(const runner::Scenario& nominal) {
  return Json::array({Stages(nominal), ClutteredViews(nominal), FittedPatches(nominal)});
}

std::vector<report::ReportPicture> PicturesFromJson(const Json& pictures) {
  std::vector<report::ReportPicture> result;
  for (const Json& each : pictures) {
    result.push_back({each.at("name").get<std::string>(), each.at("title").get<std::string>(),
                      each.at("caption").get<std::string>(), util::FromBase64(each.at("jpeg").get<std::string>()),
                      each.at("csv").get<std::string>()});
  }
  return result;
}

}  // namespace touchdown::experiments
