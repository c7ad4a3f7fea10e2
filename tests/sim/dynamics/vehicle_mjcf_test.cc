#include "sim/dynamics/vehicle_mjcf.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <string>

#include "models/camera_model.h"
#include "sim/dynamics/mujoco_model.h"
#include "sim/scene/geom_groups.h"

namespace touchdown::sim {
namespace {

using Eigen::Vector3d;

models::Vehicle HeavyVehicleWithTiltedCamera() {
  models::Vehicle vehicle;
  vehicle.mass_kg = 1.7321;
  vehicle.inertia_kg_m2 = {0.031, 0.017, 0.040};
  vehicle.arm_m = 0.27;
  vehicle.gear = {.half_spacing_m = 0.11, .height_m = 0.19, .foot_radius_m = 0.009};
  vehicle.camera = {.position_m = {0.031, -0.012, -0.047}, .misalignment_deg = {2.0, -6.0, 11.0}};
  return vehicle;
}

class VehicleMjcfTest : public ::testing::TestWithParam<models::Vehicle> {
 protected:
  VehicleMjcfTest()
      : model_(LoadModel("<mujoco><worldbody>" + VehicleMjcf(GetParam()) + "</worldbody></mujoco>")),
        data_(MakeData(*model_)),
        body_(mj_name2id(model_.get(), mjOBJ_BODY, kVehicleBodyName)) {}

  int Geom(const std::string& name) const { return mj_name2id(model_.get(), mjOBJ_GEOM, name.c_str()); }
  Vector3d InBody(const double* p_W) const {
    return Eigen::Map<const Vector3d>(p_W) - Eigen::Map<const Vector3d>(data_->xpos + 3 * body_);
  }

  MujocoModel model_;
  MujocoData data_;
  int body_;
};

TEST_P(VehicleMjcfTest, HasTheMassAndInertiaOfTheVehicle) {
  ASSERT_GE(body_, 1);
  EXPECT_EQ(model_->body_mass[body_], GetParam().mass_kg);
  EXPECT_EQ(Eigen::Map<const Vector3d>(model_->body_inertia + 3 * body_), GetParam().inertia_kg_m2);
  EXPECT_EQ(Eigen::Map<const Vector3d>(model_->body_ipos + 3 * body_), Vector3d::Zero());
  EXPECT_EQ(Eigen::Map<const Eigen::Vector4d>(model_->body_iquat + 4 * body_), Eigen::Vector4d(1, 0, 0, 0));
  EXPECT_EQ(model_->nq, 7) << "one free joint";
}

TEST_P(VehicleMjcfTest, HasFeetAtTheContactPointsOfTheVehicle) {
  const models::LandingGear& gear = GetParam().gear;
  for (int i = 0; i < models::kRotorCount; ++i) {
    const int geom = Geom(FootName(i));
    ASSERT_GE(geom, 0);
    const double radius = model_->geom_size[3 * geom];
    const Vector3d contact_point = InBody(data_->geom_xpos + 3 * geom) - Vector3d(0, 0, radius);
    const Vector3d hub = GetParam().RotorPosition(i);
    const Vector3d expected(std::copysign(gear.half_spacing_m, hub.x()), std::copysign(gear.half_spacing_m, hub.y()),
                            -gear.height_m);
    EXPECT_TRUE(contact_point.isApprox(expected, 1e-12)) << contact_point.transpose();
    EXPECT_EQ(radius, gear.foot_radius_m);
    EXPECT_EQ(model_->geom_type[geom], mjGEOM_SPHERE);
  }
}

TEST_P(VehicleMjcfTest, TouchesALevelFloorAtItsContactPointsOnly) {
  const std::string floor = "<geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/>";
  const MujocoModel model =
      LoadModel("<mujoco><worldbody>" + floor + VehicleMjcf(GetParam()) + "</worldbody></mujoco>");
  const MujocoData data = MakeData(*model);
  data->qpos[2] = GetParam().gear.height_m - 0.004;
  mj_forward(model.get(), data.get());
  EXPECT_EQ(data->ncon, 4);
  for (int i = 0; i < data->ncon; ++i) {
    EXPECT_EQ(model->geom_type[data->contact[i].geom2], mjGEOM_SPHERE);
    EXPECT_NEAR(data->contact[i].dist, -0.004, 1e-12);
  }
}

TEST_P(VehicleMjcfTest, HasTheCameraAtItsMounting) {
  const int camera = mj_name2id(model_.get(), mjOBJ_CAMERA, kOnboardCameraName);
  ASSERT_GE(camera, 0);
  const Eigen::Isometry3d X_BC = GetParam().X_BC();
  EXPECT_TRUE(InBody(data_->cam_xpos + 3 * camera).isApprox(X_BC.translation(), 1e-12));
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Matrix3d R_BM = Eigen::Map<const RowMajor>(data_->cam_xmat + 9 * camera);
  EXPECT_TRUE(R_BM.col(0).isApprox(X_BC.linear().col(0), 1e-12)) << "right";
  EXPECT_TRUE(R_BM.col(1).isApprox(-X_BC.linear().col(1), 1e-12)) << "up";
  EXPECT_TRUE(R_BM.col(2).isApprox(-X_BC.linear().col(2), 1e-12)) << "backwards";
}

TEST_P(VehicleMjcfTest, HasADiscAtEveryRotor) {
  for (int i = 0; i < models::kRotorCount; ++i) {
    const int geom = Geom("rotor_" + std::to_string(i));
    ASSERT_GE(geom, 0);
    EXPECT_TRUE(InBody(data_->geom_xpos + 3 * geom).isApprox(GetParam().RotorPosition(i), 1e-12));
    EXPECT_EQ(model_->geom_size[3 * geom], GetParam().rotor.propeller_diameter_m / 2.0);
  }
}

TEST_P(VehicleMjcfTest, UsesOneGeomGroup) {
  for (int geom = 0; geom < model_->ngeom; ++geom) EXPECT_EQ(model_->geom_group[geom], int{kVehicle});
}

INSTANTIATE_TEST_SUITE_P(Vehicles, VehicleMjcfTest,
                         ::testing::Values(models::Vehicle{}, HeavyVehicleWithTiltedCamera()),
                         [](const auto& param) { return param.index == 0 ? "Default" : "Heavy"; });

TEST(VehicleMjcf, DefaultGearIsOutsideTheCamerasView) {
  const models::Vehicle vehicle;
  const models::CameraModel camera;
  const Eigen::Isometry3d X_CB = vehicle.X_BC().inverse();
  const double inner_edge = vehicle.gear.half_spacing_m - vehicle.gear.foot_radius_m;
  for (double z = -vehicle.gear.height_m; z < 0.0; z += 0.005) {
    for (const double x : {-inner_edge, inner_edge}) {
      for (const double y : {-inner_edge, inner_edge}) {
        const auto pixel = camera.Project(X_CB * Vector3d(x, y, z));
        EXPECT_FALSE(pixel && camera.Contains(*pixel)) << "at height " << z;
      }
    }
  }
}

TEST(VehicleMjcf, OmitsLegsThatWouldBeTooShort) {
  models::Vehicle vehicle;
  vehicle.gear = {.half_spacing_m = 0.13, .height_m = 0.06, .foot_radius_m = 0.03};
  EXPECT_NO_THROW(LoadModel("<mujoco><worldbody>" + VehicleMjcf(vehicle) + "</worldbody></mujoco>"));
}

}  // namespace
}  // namespace touchdown::sim
