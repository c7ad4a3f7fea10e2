#include "sim/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "models/angles.h"
#include "models/error.h"
#include "models/random_stream.h"

namespace touchdown::sim {
namespace {

using models::RandomStream;
using Kind = SceneItem::Kind;

constexpr double kGapBetweenItems_m = 0.012;
constexpr double kGapAroundPad_m = 0.025;
constexpr double kNear_m = 1.5;
constexpr double kFar_m = 3.2;
constexpr double kFarSolid_m = 2.4;
constexpr double kFractionNear = 0.8;
constexpr int kTries = 4000;

Eigen::Vector2d AxisX(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }
Eigen::Vector2d AxisY(double yaw) { return {-std::sin(yaw), std::cos(yaw)}; }

double HalfExtentAlong(const SceneItem& item, const Eigen::Vector2d& axis) {
  return 0.5 * (item.size_m.x() * std::abs(AxisX(item.yaw).dot(axis)) +
                item.size_m.y() * std::abs(AxisY(item.yaw).dot(axis)));
}

Eigen::Vector3d DrawSize(Kind kind, RandomStream& random) {
  switch (kind) {
    case Kind::kPoster: {
      const double length = random.Uniform(0.22, 0.55);
      return {length, length * random.Uniform(0.55, 0.95), 0.0};
    }
    case Kind::kRing: {
      const double length = random.Uniform(0.12, 0.30);
      return {length, length * random.Uniform(0.70, 1.0), 0.0};
    }
    case Kind::kLetterH:
    case Kind::kRectangle: {
      const double length = random.Uniform(0.12, 0.28);
      return {length, length * random.Uniform(0.55, 1.0), 0.0};
    }
    case Kind::kBox:
      return {random.Uniform(0.08, 0.35), random.Uniform(0.08, 0.30), random.Uniform(0.05, 0.30)};
    case Kind::kCylinder: {
      const double diameter = random.Uniform(0.06, 0.22);
      return {diameter, diameter, random.Uniform(0.05, 0.30)};
    }
    case Kind::kBall:
      return Eigen::Vector3d::Constant(random.Uniform(0.10, 0.24));
    case Kind::kStone: {
      const double length = random.Uniform(0.06, 0.28);
      return length * Eigen::Vector3d(1.0, random.Uniform(0.6, 0.95), random.Uniform(0.3, 0.6));
    }
  }
  return Eigen::Vector3d::Zero();
}

Kind DrawSolid(const SceneConfig& config, RandomStream& random) {
  if (!config.IsOutdoor()) return random.Bernoulli(0.5) ? Kind::kBox : Kind::kCylinder;
  constexpr std::array kSolids{Kind::kStone, Kind::kStone, Kind::kStone, Kind::kBox, Kind::kCylinder, Kind::kBall};
  return kSolids[static_cast<std::size_t>(random.UniformInt(0, int{kSolids.size()} - 1))];
}

class Layout {
 public:
  Layout(Scene& scene, RandomStream& random) : scene_(scene), random_(random) {
    pad_sheet_.size_m = {scene.pad.sheet_length_m, scene.pad.sheet_width_m, 0.0};
  }

  void Place(Kind kind) {
    SceneItem item{.kind = kind, .size_m = DrawSize(kind, random_), .texture_seed = random_.Bits()};
    const double radius = 0.5 * item.size_m.head<2>().norm();
    const double nearest = item.IsFlat() ? 0.0 : kSolidKeepOut_m + radius;
    double farthest = item.IsFlat() ? (random_.Bernoulli(kFractionNear) ? kNear_m : kFar_m) : kFarSolid_m;
    const double limit = 0.5 * scene_.config.floor_size_m - radius;
    for (int i = 0; i < kTries; ++i) {
      const double distance = random_.Uniform(nearest, std::min(farthest, limit));
      item.position_m = distance * AxisX(random_.Uniform(-models::kPi, models::kPi));
      item.yaw = random_.Uniform(-models::kPi, models::kPi);
      if (IsFree(item)) {
        scene_.items.push_back(item);
        return;
      }
      farthest *= 1.001;
    }
    throw InputError("the scene's floor_size_m is too small for its posters, lone_circles, lone_letters and objects");
  }

 private:
  bool IsFree(const SceneItem& item) const {
    if (Overlap(item, pad_sheet_, kGapAroundPad_m)) return false;
    return std::none_of(scene_.items.begin(), scene_.items.end(),
                        [&](const SceneItem& other) { return Overlap(item, other, kGapBetweenItems_m); });
  }

  Scene& scene_;
  RandomStream& random_;
  SceneItem pad_sheet_;
};

}  // namespace

void Describe(models::ConfigVisitor& v, SceneConfig& c) {
  using namespace models;
  constexpr Range kCount = Between(0, 40);
  v.Choice({"setting",
            "Surroundings: indoor is a floor between four walls, outdoor is a sunlit meadow with a path past the pad."},
           c.setting, SceneConfig::kSettingNames);
  v.Number({"floor_size_m", "Side of the square floor. The room is a cube of this size."}, c.floor_size_m, kMeter,
           Between(4.0, 30.0));
  v.Integer({"posters", "Number of flat sheets with rich texture."}, c.posters, kCount);
  v.Integer({"lone_circles", "Number of rings without an H."}, c.lone_circles, kCount);
  v.Integer({"lone_letters", "Number of letters without a ring: an H, or a rectangle where the pad has one."},
            c.lone_letters, kCount);
  v.Integer({"objects", "Number of solid objects: boxes and cylinders, outdoors also stones and balls."}, c.objects,
            kCount);
  v.Number({"illumination", "Gain of the light; 1 is nominal. Above about 1.13, white paper saturates the image."},
           c.illumination, kNoUnit, PositiveUpTo(4.0));
  v.Boolean({"pad", "Whether the landing pad is in the scene."}, c.pad);
  v.Keys({"sun", "The sun and its shadows (outdoor only)."}, c.sun);
  v.Check("", [&c] {
    if (c.posters + c.lone_circles + c.lone_letters + c.objects > 80) {
      throw InputError("scene: posters, lone_circles, lone_letters and objects must add up to at most 80");
    }
  });
}

void SceneConfig::Validate() const { models::ValidateConfig(*this); }

std::array<Eigen::Vector2d, 4> SceneItem::Corners() const {
  const Eigen::Vector2d half_x = 0.5 * size_m.x() * AxisX(yaw);
  const Eigen::Vector2d half_y = 0.5 * size_m.y() * AxisY(yaw);
  return {position_m - half_x - half_y, position_m + half_x - half_y, position_m + half_x + half_y,
          position_m - half_x + half_y};
}

bool Overlap(const SceneItem& a, const SceneItem& b, double gap_m) {
  const Eigen::Vector2d between = b.position_m - a.position_m;
  for (const Eigen::Vector2d& axis : {AxisX(a.yaw), AxisY(a.yaw), AxisX(b.yaw), AxisY(b.yaw)}) {
    const double reach = HalfExtentAlong(a, axis) + HalfExtentAlong(b, axis) + gap_m;
    if (std::abs(between.dot(axis)) >= reach) return false;
  }
  return true;
}

Scene MakeScene(const SceneConfig& config, const models::LandingPad& pad, std::uint64_t seed) {
  config.Validate();
  pad.Validate();
  RandomStream random(seed, "scene");
  Scene scene{.config = config, .pad = pad, .items = {}, .floor_seed = random.Bits()};
  Layout layout(scene, random);
  for (int i = 0; i < config.lone_circles; ++i) layout.Place(Kind::kRing);
  const Kind letter = pad.letter() == models::PadLetter::kRectangle ? Kind::kRectangle : Kind::kLetterH;
  for (int i = 0; i < config.lone_letters; ++i) layout.Place(letter);
  for (int i = 0; i < config.objects; ++i) layout.Place(DrawSolid(config, random));
  for (int i = 0; i < config.posters; ++i) layout.Place(Kind::kPoster);
  return scene;
}

}  // namespace touchdown::sim
