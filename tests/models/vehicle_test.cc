#include "models/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "models/error.h"

namespace touchdown::models {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

TEST(Vehicle, HasThePapersParametersByDefault) {
  const Vehicle vehicle;
  EXPECT_NO_THROW(vehicle.Validate());
  EXPECT_EQ(vehicle.mass_kg, 1.2);
  EXPECT_NEAR(vehicle.rotor.propeller_diameter_m, 0.254, 1e-12) << "10 inches";
  EXPECT_GT(kRotorCount * vehicle.rotor.ThrustAt(vehicle.rotor.max_speed_rad_s), 1.3 * 1.6 * kGravity_m_s2)
      << "lifts 400 g of payload with a margin";
}

TEST(Vehicle, HasRotorsInXConfiguration) {
  const Vehicle vehicle;
  const double d = 0.2 / std::sqrt(2.0);
  EXPECT_TRUE(vehicle.RotorPosition(0).isApprox(Vector3d(d, d, 0.03))) << "front left";
  EXPECT_TRUE(vehicle.RotorPosition(1).isApprox(Vector3d(d, -d, 0.03))) << "front right";
  EXPECT_TRUE(vehicle.RotorPosition(2).isApprox(Vector3d(-d, -d, 0.03))) << "rear right";
  EXPECT_TRUE(vehicle.RotorPosition(3).isApprox(Vector3d(-d, d, 0.03))) << "rear left";
  EXPECT_LT(vehicle.rotor.propeller_diameter_m, 2.0 * d) << "propellers do not touch";
}

TEST(Vehicle, SpinsNeighboringRotorsInOppositeDirections) {
  for (int i = 0; i < kRotorCount; ++i) {
    EXPECT_EQ(Vehicle::DragTorqueSign(i), -Vehicle::DragTorqueSign((i + 1) % kRotorCount));
  }
  EXPECT_EQ(Vehicle::DragTorqueSign(0), 1.0);
}

TEST(Rotor, InvertsItsThrust) {
  const Rotor rotor;
  EXPECT_NEAR(rotor.ThrustAt(477.0), 2.94, 0.01);
  for (const double speed : {0.0, 1.0, 300.0, 660.0}) EXPECT_NEAR(rotor.SpeedFor(rotor.ThrustAt(speed)), speed, 1e-9);
  EXPECT_EQ(rotor.SpeedFor(0.0), 0.0);
  EXPECT_EQ(rotor.SpeedFor(-1.0), 0.0);
}

TEST(Vehicle, HoversWithAQuarterOfItsWeightPerRotor) {
  EXPECT_NEAR(kRotorCount * Vehicle{}.HoverThrustPerRotor(), 1.2 * 9.81, 1e-12);
}

TEST(Vehicle, HasACameraThatLooksDownWithTheImagesTopForward) {
  const Eigen::Isometry3d X_BC = Vehicle{}.X_BC();
  EXPECT_TRUE((X_BC.linear() * Vector3d::UnitZ()).isApprox(-Vector3d::UnitZ())) << "looks down";
  EXPECT_TRUE((X_BC.linear() * -Vector3d::UnitY()).isApprox(Vector3d::UnitX())) << "up is forward";
  EXPECT_TRUE((X_BC.linear() * Vector3d::UnitX()).isApprox(-Vector3d::UnitY())) << "right is right";
  EXPECT_NEAR(X_BC.linear().determinant(), 1.0, 1e-15);
  EXPECT_EQ(X_BC.translation(), Vector3d(0.0, 0.0, -0.05));
}

TEST(Vehicle, RotatesASensorByItsMisalignmentInTheBody) {
  Vehicle vehicle;
  vehicle.camera.misalignment_deg.pitch = RadToDeg(0.1);
  vehicle.imu = {.position_m = {0.01, 0.02, 0.03}, .misalignment_deg = {.roll = RadToDeg(0.2)}};
  const Vector3d optical_axis = vehicle.X_BC().linear() * Vector3d::UnitZ();
  EXPECT_TRUE(optical_axis.isApprox(Vector3d(-std::sin(0.1), 0.0, -std::cos(0.1)), 1e-12));
  EXPECT_TRUE(vehicle.X_BU().linear().isApprox(RotationFromTaitBryan({.roll = 0.2}), 1e-15));
  EXPECT_EQ(vehicle.X_BU().translation(), Vector3d(0.01, 0.02, 0.03));
  EXPECT_TRUE(Vehicle{}.X_BU().isApprox(Eigen::Isometry3d::Identity()));
}

struct Fault {
  std::string name;
  std::function<void(Vehicle&)> make;
};

TEST(VehicleValidate, RejectsNonpositiveQuantitiesThatMustBePositive) {
  const std::vector<std::function<double&(Vehicle&)>> quantities = {
      [](Vehicle& v) -> double& { return v.mass_kg; },
      [](Vehicle& v) -> double& { return v.inertia_kg_m2.x(); },
      [](Vehicle& v) -> double& { return v.inertia_kg_m2.y(); },
      [](Vehicle& v) -> double& { return v.inertia_kg_m2.z(); },
      [](Vehicle& v) -> double& { return v.arm_m; },
      [](Vehicle& v) -> double& { return v.rotor.thrust_coefficient_n_s2; },
      [](Vehicle& v) -> double& { return v.rotor.torque_ratio_m; },
      [](Vehicle& v) -> double& { return v.rotor.time_constant_s; },
      [](Vehicle& v) -> double& { return v.rotor.max_speed_rad_s; },
      [](Vehicle& v) -> double& { return v.rotor.propeller_diameter_m; },
      [](Vehicle& v) -> double& { return v.gear.half_spacing_m; },
      [](Vehicle& v) -> double& { return v.gear.height_m; },
      [](Vehicle& v) -> double& { return v.gear.foot_radius_m; },
  };
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    for (const double value : {0.0, -1.0, kNan, kInfinity}) {
      Vehicle vehicle;
      quantities[i](vehicle) = value;
      EXPECT_THROW(vehicle.Validate(), InputError) << "quantity " << i << " at " << value;
    }
  }
}

TEST(VehicleValidate, RejectsNumbersThatAreNotFinite) {
  const std::vector<std::function<double&(Vehicle&)>> quantities = {
      [](Vehicle& v) -> double& { return v.rotor_height_m; },
      [](Vehicle& v) -> double& { return v.rotor.min_speed_rad_s; },
      [](Vehicle& v) -> double& { return v.linear_drag_n_s_m.y(); },
      [](Vehicle& v) -> double& { return v.quadratic_drag_n_s2_m2.z(); },
      [](Vehicle& v) -> double& { return v.camera.position_m.x(); },
      [](Vehicle& v) -> double& { return v.camera.misalignment_deg.yaw; },
      [](Vehicle& v) -> double& { return v.imu.position_m.z(); },
      [](Vehicle& v) -> double& { return v.imu.misalignment_deg.roll; },
  };
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      Vehicle vehicle;
      quantities[i](vehicle) = value;
      EXPECT_THROW(vehicle.Validate(), InputError) << "quantity " << i << " at " << value;
    }
  }
}

TEST(VehicleValidate, RejectsVehiclesThatCannotFly) {
  const std::vector<Fault> faults = {
      {"negative linear drag", [](Vehicle& v) { v.linear_drag_n_s_m.x() = -0.1; }},
      {"negative quadratic drag", [](Vehicle& v) { v.quadratic_drag_n_s2_m2.y() = -0.1; }},
      {"inertia that violates the triangle inequality",
       [](Vehicle& v) {
         v.inertia_kg_m2 = {0.01, 0.01, 0.021};
       }},
      {"negative idle speed", [](Vehicle& v) { v.rotor.min_speed_rad_s = -1.0; }},
      {"idle above the highest speed", [](Vehicle& v) { v.rotor.min_speed_rad_s = 660.0; }},
      {"too heavy", [](Vehicle& v) { v.mass_kg = 2.4; }},
      {"camera not above the contact points", [](Vehicle& v) { v.camera.position_m.z() = -0.14; }},
  };
  for (const Fault& fault : faults) {
    Vehicle vehicle;
    fault.make(vehicle);
    EXPECT_THROW(vehicle.Validate(), InputError) << fault.name;
  }
}

TEST(Vehicle, ComputesTheMountingFromASensorsPose) {
  Vehicle vehicle;
  vehicle.camera = {.position_m = {0.03, -0.01, -0.04}, .misalignment_deg = {6.0, -12.0, 115.0}};
  vehicle.imu = {.position_m = {0.01, 0.02, 0.03}, .misalignment_deg = {-17.0, 6.0, -57.0}};
  Vehicle again;
  again.camera = CameraMountingOf(vehicle.X_BC());
  again.imu = ImuMountingOf(vehicle.X_BU());
  EXPECT_TRUE(again.X_BC().isApprox(vehicle.X_BC(), 1e-14));
  EXPECT_TRUE(again.X_BU().isApprox(vehicle.X_BU(), 1e-14));
  EXPECT_NEAR(again.camera.misalignment_deg.yaw, 115.0, 1e-12);
}

}  // namespace
}  // namespace touchdown::models
