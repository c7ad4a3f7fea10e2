#include "sim/dynamics/vehicle_mjcf.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <sstream>

#include "sim/scene/geom_groups.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

constexpr char kCarbon[] = "0.12 0.12 0.13 1";
constexpr char kHullPaint[] = "0.75 0.16 0.10 1";
constexpr char kMetal[] = "0.45 0.46 0.48 1";
constexpr char kRubber[] = "0.05 0.05 0.05 1";
constexpr char kFrontRotor[] = "0.85 0.45 0.10 0.35";
constexpr char kRearRotor[] = "0.20 0.20 0.22 0.35";

enum class Contact { kNone, kBody, kFoot };

std::string Numbers(std::initializer_list<double> values) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  const char* separator = "";
  for (const double value : values) {
    out << separator << value;
    separator = " ";
  }
  return out.str();
}

std::string Numbers(const Vector3d& v) { return Numbers({v.x(), v.y(), v.z()}); }

std::string Attribute(const std::string& name, const std::string& value) { return " " + name + "=\"" + value + "\""; }

std::string ContactAttributes(Contact contact) {
  switch (contact) {
    case Contact::kNone:
      return R"( contype="0" conaffinity="0")";
    case Contact::kBody:
      return R"( contype="1" conaffinity="1" priority="1" condim="3" friction="0.5 0.005 0.0001" solref="0.01 1")";
    case Contact::kFoot:  // Critically damped rubber: contact at 0.5 m/s compresses it by about 3 mm, without a bounce.
      return R"( contype="1" conaffinity="1" priority="2" condim="3" friction="1 0.005 0.0001" solref="0.015 1")"
             R"( solimp="0.9 0.95 0.001")";
  }
  return {};
}

std::string Geom(const std::string& name, const std::string& type, const std::string& shape, const std::string& rgba,
                 Contact contact) {
  return "  <geom" + Attribute("name", name) + Attribute("type", type) + shape + Attribute("rgba", rgba) +
         Attribute("group", std::to_string(kVehicle)) + ContactAttributes(contact) + "/>\n";
}

std::string At(const Vector3d& position, std::initializer_list<double> size) {
  return Attribute("pos", Numbers(position)) + Attribute("size", Numbers(size));
}

std::string CapsuleBetween(const Vector3d& from, const Vector3d& to, double radius) {
  return Attribute("fromto", Numbers({from.x(), from.y(), from.z(), to.x(), to.y(), to.z()})) +
         Attribute("size", Numbers({radius}));
}

std::string HullGeoms(const models::Vehicle& vehicle) {
  const double arm = vehicle.arm_m;
  const double hull_half_height = std::min(0.09 * arm, 0.4 * vehicle.gear.height_m);
  return Geom("hull", "box", At(Vector3d::Zero(), {0.32 * arm, 0.20 * arm, hull_half_height}), kHullPaint,
              Contact::kBody) +
         Geom("battery", "box", At({-0.02 * arm, 0.0, 0.12 * arm}, {0.26 * arm, 0.13 * arm, 0.07 * arm}), kCarbon,
              Contact::kNone) +
         Geom("camera_housing", "box",
              At(vehicle.camera.position_m + Vector3d(0, 0, 0.06 * arm), {0.07 * arm, 0.07 * arm, 0.06 * arm}), kMetal,
              Contact::kNone);
}

std::string ArmGeoms(const models::Vehicle& vehicle, int rotor) {
  const std::string index = std::to_string(rotor);
  const Vector3d hub = vehicle.RotorPosition(rotor);
  const Vector3d motor_base = hub - Vector3d(0, 0, 0.12 * vehicle.arm_m);
  const Vector3d root(0.15 * hub.x(), 0.15 * hub.y(), 0.0);
  const double disc_radius = vehicle.rotor.propeller_diameter_m / 2.0;
  return Geom("arm_" + index, "capsule", CapsuleBetween(root, motor_base, 0.04 * vehicle.arm_m), kCarbon,
              Contact::kNone) +
         Geom("motor_" + index, "cylinder", CapsuleBetween(motor_base, hub, 0.07 * vehicle.arm_m), kMetal,
              Contact::kNone) +
         Geom("rotor_" + index, "cylinder", At(hub, {disc_radius, 0.015 * vehicle.arm_m}),
              rotor < 2 ? kFrontRotor : kRearRotor, Contact::kBody);
}

std::string LegGeoms(const models::Vehicle& vehicle, int foot) {
  const models::LandingGear& gear = vehicle.gear;
  const Vector3d hub = vehicle.RotorPosition(foot);
  const double forward = hub.x() > 0.0 ? gear.half_spacing_m : -gear.half_spacing_m;
  const double left = hub.y() > 0.0 ? gear.half_spacing_m : -gear.half_spacing_m;
  const Vector3d foot_center(forward, left, gear.foot_radius_m - gear.height_m);
  std::string geoms = Geom(FootName(foot), "sphere", At(foot_center, {gear.foot_radius_m}), kRubber, Contact::kFoot);
  if (gear.height_m > 3.0 * gear.foot_radius_m) {
    const Vector3d ankle = foot_center + Vector3d(0, 0, gear.foot_radius_m);
    geoms += Geom("leg_" + std::to_string(foot), "capsule",
                  CapsuleBetween({forward, left, 0.0}, ankle, 0.45 * gear.foot_radius_m), kCarbon, Contact::kBody);
  }
  return geoms;
}

std::string CameraElement(const models::Vehicle& vehicle) {
  const Eigen::Isometry3d X_BC = vehicle.X_BC();
  const Eigen::Matrix3d R_BM = X_BC.linear() * Vector3d(1.0, -1.0, -1.0).asDiagonal();
  const Eigen::Quaterniond q_BM(R_BM);
  return std::string("  <camera") + Attribute("name", kOnboardCameraName) + Attribute("mode", "fixed") +
         Attribute("pos", Numbers(X_BC.translation())) +
         Attribute("quat", Numbers({q_BM.w(), q_BM.x(), q_BM.y(), q_BM.z()})) + "/>\n";
}

}  // namespace

std::string FootName(int foot) { return "foot_" + std::to_string(foot); }

std::string VehicleMjcf(const models::Vehicle& vehicle) {
  std::string body = std::string("<body") + Attribute("name", kVehicleBodyName) +
                     Attribute("pos", Numbers({0.0, 0.0, vehicle.gear.height_m})) + ">\n  <freejoint/>\n" +
                     "  <inertial pos=\"0 0 0\"" + Attribute("mass", Numbers({vehicle.mass_kg})) +
                     Attribute("diaginertia", Numbers(vehicle.inertia_kg_m2)) + "/>\n" + CameraElement(vehicle) +
                     HullGeoms(vehicle);
  for (int i = 0; i < models::kRotorCount; ++i) body += ArmGeoms(vehicle, i) + LegGeoms(vehicle, i);
  return body + "</body>\n";
}

}  // namespace touchdown::sim
