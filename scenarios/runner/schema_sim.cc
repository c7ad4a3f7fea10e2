#include "scenarios/runner/scenario_schema.h"

#include "scenarios/config/camera_info.h"

namespace touchdown::config {

using namespace runner;
namespace {

constexpr Unit kRadianPerSecondRootHertz{"rad/s/sqrt(Hz)"};

void DescribeRotor(ConfigVisitor& v, models::Rotor& r) {
  v.Number({"thrust_coefficient_n_s2", "Thrust over squared speed in rad/s."}, r.thrust_coefficient_n_s2, {"N s^2"},
           kPositive);
  v.Number({"torque_ratio_m", "Drag torque in Nm for each N of thrust."}, r.torque_ratio_m, kMetre, kPositive);
  v.Number({"time_constant_s", "Of the lag from command to speed."}, r.time_constant_s, kSecond, kPositiveTime);
  v.Number({"max_speed_rad_s", "Highest speed."}, r.max_speed_rad_s, kRadianPerSecond, kPositive);
  v.Number({"min_speed_rad_s", "Idle of a running motor."}, r.min_speed_rad_s, kRadianPerSecond, kNotNegative);
  v.Number({"propeller_diameter_m", "Of the propeller."}, r.propeller_diameter_m, kMetre, kPositive);
}

void DescribeGear(ConfigVisitor& v, models::LandingGear& g) {
  v.Number({"half_spacing_m", "Half of the distance between feet, along X and Y."}, g.half_spacing_m, kMetre,
           kPositive);
  v.Number({"height_m", "From the body's origin down to the soles."}, g.height_m, kMetre, kPositive);
  v.Number({"foot_radius_m", "Of each foot."}, g.foot_radius_m, kMetre, kPositive);
}

/// The keys of a camera's model of a file that may be a ROS camera_info calibration.
ConfigNode CameraModelKeys(ConfigNode root) { return IsCameraInfo(root) ? CameraModelFromCameraInfo(root) : root; }

void DescribeSun(ConfigVisitor& v, sim::Sun& c) {
  v.Number({"elevation_deg", "Over the ground's plane."}, c.elevation, kDegree, Between(10.0, 90.0));
  v.Number({"azimuth_deg", "Where it stands, from W's X towards Y."}, c.azimuth, kDegree, Between(-360.0, 360.0));
  v.Number({"to_sky", "Its light on the ground over the sky's; 0 is overcast, without shadows."}, c.to_sky, kNoUnit,
           Between(0.0, 20.0));
}

}  // namespace

void DescribeCalibration(ConfigVisitor& v, Calibration& c, const models::CameraModel& camera,
                         const models::Vehicle& vehicle) {
  v.OptionalKeys({"camera_model", "Instead of camera.model: in place, or the name of a ROS camera_info file."},
                 c.camera_model, camera, {true, CameraModelKeys});
  v.OptionalKeys({"camera", "Instead of vehicle.camera."}, c.camera, vehicle.camera);
  v.OptionalKeys({"imu", "Instead of vehicle.imu."}, c.imu, vehicle.imu);
}

void Describe(ConfigVisitor& v, Calibration& c) { DescribeCalibration(v, c, {}, {}); }

void Describe(ConfigVisitor& v, models::Mounting& m) {
  v.Vector3({"position_m", "Position in B."}, m.position_m, kMetre, Between(-2.0, 2.0));
  v.Numbers({"misalignment_deg", "Roll, pitch and yaw that turn the sensor from its nominal orientation, in B."},
            {&m.misalignment.roll, &m.misalignment.pitch, &m.misalignment.yaw}, kDegree, Between(-180.0, 180.0));
}

void Describe(ConfigVisitor& v, models::Vehicle& c) {
  v.Number({"mass_kg", "With battery and payload."}, c.mass_kg, kKilogram, kPositive);
  v.Vector3({"inertia_kg_m2", "Principal moments along the body's axes."}, c.inertia_kg_m2, {"kg m^2"}, kPositive);
  v.Number({"arm_m", "From the origin to each rotor."}, c.arm_m, kMetre, kPositive);
  v.Number({"rotor_height_m", "Of the rotor plane above the origin."}, c.rotor_height_m, kMetre, Between(-2.0, 2.0));
  v.Section({"rotor", "One of the four rotors."}, {}, [&c](ConfigVisitor& s) { DescribeRotor(s, c.rotor); });
  v.Vector3({"linear_drag_n_s_m", "Force per airspeed along the body's axes."}, c.linear_drag_n_s_m, {"N s/m"},
            kNotNegative);
  v.Vector3({"quadratic_drag_n_s2_m2", "Force per squared airspeed along the body's axes."}, c.quadratic_drag_n_s2_m2,
            {"N s^2/m^2"}, kNotNegative);
  v.Section({"gear", "The landing gear."}, {}, [&c](ConfigVisitor& s) { DescribeGear(s, c.gear); });
  v.Keys({"camera", "How the camera is mounted; nominally it looks down, the image's up towards body forward."},
         c.camera);
  v.Keys({"imu", "How the IMU is mounted; nominally its axes are the body's."}, c.imu);
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, models::CameraModel& c) {
  v.Integer({"width_px", "Image width."}, c.width_px, kImageSize_px);
  v.Integer({"height_px", "Image height."}, c.height_px, kImageSize_px);
  v.Number({"fx_px", "Focal length."}, c.fx_px, kPixel, kPositive);
  v.Number({"fy_px", "Focal length."}, c.fy_px, kPixel, kPositive);
  v.Number({"cx_px", "Principal point; pixel centres lie on integers."}, c.cx_px, kPixel, kAny);
  v.Number({"cy_px", "Principal point."}, c.cy_px, kPixel, kAny);
  v.Number({"k1", "First radial distortion term (plumb_bob)."}, c.k1, kNoUnit, kAny);
  v.Number({"k2", "Second radial distortion term."}, c.k2, kNoUnit, kAny);
  v.Number({"p1", "First tangential distortion term."}, c.p1, kNoUnit, kAny);
  v.Number({"p2", "Second tangential distortion term."}, c.p2, kNoUnit, kAny);
  v.Number({"k3", "Third radial distortion term."}, c.k3, kNoUnit, kAny);
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, models::LandingPad& c) {
  v.Number({"outer_radius_m", "Of the ring."}, c.outer_radius_m, kMetre, kPositive);
  v.Number({"ring_width_m", "Of the ring's black."}, c.ring_width_m, kMetre, kPositive);
  v.Number({"h_height_m", "Length of the H's long strokes, along X."}, c.h_height_m, kMetre, kPositive);
  v.Number({"h_width_m", "Over both long strokes, along Y."}, c.h_width_m, kMetre, kPositive);
  v.Number({"h_stroke_m", "Width of the H's strokes. Half of h_width_m makes the H a solid rectangle."}, c.h_stroke_m,
           kMetre, kPositive);
  v.Number({"sheet_length_m", "Of the white sheet, along X."}, c.sheet_length_m, kMetre, kPositive);
  v.Number({"sheet_width_m", "Of the white sheet, along Y."}, c.sheet_width_m, kMetre, kPositive);
  v.List(
      {"marks", "What else is printed in black within the ring; it may touch or overlap the H."}, c.marks.size(),
      [&c](std::size_t count) { c.marks.assign(count, {}); },
      [&c](ConfigVisitor& item, std::size_t index) {
        Describe(item, c.marks[index]);
        item.Check("", [&c, index] { c.marks[index].Validate(c.inner_radius_m()); });
      });
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, models::PadMark& m) {
  v.Choice({"shape", "What it is.", true}, m.shape, models::PadMark::kShapeNames);
  v.Number({"x_m", "Of its centre, in W.", true}, m.centre_m.x(), kMetre, kAny);
  v.Number({"y_m", "Of its centre, in W.", true}, m.centre_m.y(), kMetre, kAny);
  switch (m.shape) {
    case models::PadMark::Shape::kDisc:
      v.Number({"diameter_m", "Across it (disc only).", true}, m.diameter_m, kMetre, kPositive);
      break;
    case models::PadMark::Shape::kBar:
      v.Number({"length_m", "Along angle_deg (bar only).", true}, m.length_m, kMetre, kPositive);
      v.Number({"width_m", "Across its length (bar only).", true}, m.width_m, kMetre, kPositive);
      v.Number({"angle_deg", "Of its length, from W's X towards Y (bar only)."}, m.angle, kDegree,
               Between(-180.0, 180.0));
      break;
  }
}

void Describe(ConfigVisitor& v, sim::ImuConfig& c) {
  v.Integer({"rate_hz", "Samples a second, and the rate of the attitude loop; divides time.ticks_per_s."}, c.rate_hz,
            Between(1, 100000));
  v.Number({"gyro_noise_rad_s_sqrt_hz", "Density of the gyro's white noise."}, c.gyro_noise_rad_s_sqrt_hz,
           kRadianPerSecondRootHertz, kNotNegative);
  v.Number({"accelerometer_noise_m_s2_sqrt_hz", "Density of the accelerometer's white noise."},
           c.accelerometer_noise_m_s2_sqrt_hz, kMetrePerSecond2RootHertz, kNotNegative);
  v.Number({"gyro_bias_sigma_deg_s", "1-sigma of the turn-on bias of each axis."}, c.gyro_bias_sigma_rad_s,
           kDegreePerSecond, kNotNegative);
  v.Number({"accelerometer_bias_sigma_m_s2", "1-sigma of the turn-on bias of each axis."},
           c.accelerometer_bias_sigma_m_s2, kMetrePerSecond2, kNotNegative);
  v.Number({"gyro_range_deg_s", "Beyond it the gyro saturates."}, c.gyro_range_rad_s, kDegreePerSecond, kPositive);
  v.Number({"accelerometer_range_m_s2", "Beyond it the accelerometer saturates."}, c.accelerometer_range_m_s2,
           kMetrePerSecond2, kPositive);
}

void Describe(ConfigVisitor& v, sim::TrackingSystemConfig& c) {
  v.Integer({"rate_hz", "Poses a second; divides time.ticks_per_s."}, c.rate_hz, Between(1, 100000));
  v.Number({"position_noise_m", "1-sigma, per axis."}, c.position_noise_m, kMetre, kNotNegative);
  v.Number({"rotation_noise_deg", "1-sigma, per axis."}, c.rotation_noise_rad, kDegree, kNotNegative);
  v.Number({"occlusions_per_s", "Mean rate at which occlusions of the markers begin."}, c.occlusions_per_s, kPerSecond,
           kNotNegative);
  v.Number({"occlusion_duration_s", "Mean length of an occlusion."}, c.occlusion_duration_s, kSecond, kTime);
  v.Number({"outlier_probability", "That an occlusion gives outliers; otherwise it is a gap."}, c.outlier_probability,
           kNoUnit, kFraction);
  v.Number({"outlier_position_m", "1-sigma per axis of an outlier's offset."}, c.outlier_position_m, kMetre,
           kNotNegative);
  v.Number({"outlier_rotation_deg", "1-sigma per axis of an outlier's rotation."}, c.outlier_rotation_rad, kDegree,
           kNotNegative);
}

void Describe(ConfigVisitor& v, sim::HandConfig& c) {
  v.Boolean({"carries", "Whether there is a hand; the vehicle then starts on its feet, and has no script."}, c.carries);
  v.Number({"duration_s", "From lifting the vehicle to the end."}, c.duration_s, kSecond, Between(10.0, 600.0));
  v.Number({"max_height_m", "Of the body's origin."}, c.max_height_m, kMetre, Between(0.5, 3.0));
  v.Number({"max_tilt_deg", "Of roll and of pitch."}, c.max_tilt_rad, kDegree, Between(0.0, 40.0));
  v.Number({"max_yaw_deg", "To either side."}, c.max_yaw_rad, kDegree, Between(0.0, 80.0));
  v.Number({"tremor_m", "Amplitude of the hand's tremor, along each axis."}, c.tremor_m, kMetre, Between(0.0, 0.01));
  v.Number({"tremor_deg", "Its amplitude about each axis."}, c.tremor_rad, kDegree, Between(0.0, 0.5));
  v.Number({"tremor_hz", "Its frequency."}, c.tremor_hz, kHertz, Between(0.1, 30.0));
}

void Describe(ConfigVisitor& v, sim::SceneConfig& c) {
  v.Choice({"setting", "A room, or a meadow with a path past the pad, under the sun."}, c.setting,
           sim::SceneConfig::kSettingNames);
  v.Number({"floor_size_m", "Side of the square floor. The room ends with it."}, c.floor_size_m, kMetre,
           Between(4.0, 30.0));
  v.Integer({"posters", "Sheets rich in texture."}, c.posters, Between(0, 40));
  v.Integer({"lone_circles", "Rings without an H."}, c.lone_circles, Between(0, 40));
  v.Integer({"lone_letters", "Letters without a ring: Hs, or rectangles where the pad has one."}, c.lone_letters,
            Between(0, 40));
  v.Integer({"objects", "Solid boxes and cylinders; outdoors stones and balls too."}, c.objects, Between(0, 40));
  v.Number({"illumination", "Gain of the light, 1 is nominal."}, c.illumination, kNoUnit, PositiveUpTo(4.0));
  v.Boolean({"pad", "Whether the landing pad is there."}, c.pad);
  v.Section({"sun", "The sun and its shadows, outdoors; the room has none."}, {},
            [&c](ConfigVisitor& s) { DescribeSun(s, c.sun); });
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, sim::WorldConfig& c) {
  v.Vector3({"wind_m_s", "Mean wind in W, until an event changes it."}, c.wind_m_s, kMetrePerSecond,
            Between(-50.0, 50.0));
  v.Numbers(
      {"ground_tilt_deg", "Roll and pitch of the ground, and of W with it, against level; 15 degrees at the most."},
      {&c.ground_tilt.roll, &c.ground_tilt.pitch}, kDegree, Between(-15.0, 15.0));
  v.Number({"imbalance_kg_m", "Mass times eccentricity of each rotor: it shakes IMU and camera."},
           c.vibration.imbalance_kg_m, {"kg m"}, Between(0.0, 1.0));
  v.Check("ground_tilt_deg", [&c] { c.ground_tilt.Validate(); });
  v.Check("", [&c] { c.Validate(); });
}

void DescribeCamera(ConfigVisitor& v, sim::CameraConfig& c, const models::TimeBase& time) {
  v.KeysOrFile({"model", "Image size, lens and distortion: in place, or the name of a ROS camera_info file."}, c.model,
               CameraModelKeys);
  v.Integer({"rate_hz", "Frames a second; divides time.ticks_per_s."}, c.rate_hz, Between(1, 100000));
  v.Number({"noise_sigma", "1-sigma of each pixel's noise, of 255 grey levels."}, c.noise_sigma, kNoUnit,
           Between(0.0, 64.0));
  v.Number({"exposure_ms", "How long the shutter is open."}, c.exposure_s, kMillisecond, Between(0.0, 1000.0));
  v.Number({"latency_ms", "From mid-exposure to delivery; at least half the exposure."}, c.latency_s, kMillisecond,
           Between(0.0, 1000.0));
  v.Number({"vibration_rad_s2_m", "Tilt of the camera's mount per acceleration of the rotors' vibration."},
           c.vibration_rad_s2_m, {"rad s^2/m"}, Between(0.0, 1.0));
  v.Check("", [&c, &time] { c.Validate(time); });
}

}  // namespace touchdown::config
