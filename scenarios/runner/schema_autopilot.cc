#include "scenarios/runner/scenario_schema.h"

namespace touchdown::config {

using namespace runner;
namespace {

constexpr std::array<std::string_view, 2> kContourPointNames = {"integer", "subpixel"};
constexpr std::array<std::string_view, 2> kVerifyNames = {"none", "template"};

constexpr Unit kRadianPerSecond2{"rad/s^2"};

}  // namespace

void Describe(ConfigVisitor& v, estimator::paper::PaperOptions& c) {
  v.Choice({"contour_points", "Where edge points are taken: on Canny's pixels, or at their sub-pixel places."},
           c.contour_points, kContourPointNames);
  v.Choice({"verify",
            "How a ring and an H that may be the pad are verified: not at all, as published, or by a template match of "
            "the pad's artwork."},
           c.verify, kVerifyNames);
}

void Describe(ConfigVisitor& v, estimator::EstimatorConfig& c) {
  v.Text({"name", "Which estimator turns frames into poses."}, c.name);
  v.Keys({"paper", "Options of the estimator paper, the method of Yang et al."}, c.paper);
  v.Renamed("contour_points", "paper.contour_points");
  v.Check("name", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, estimator::AttitudeEstimatorConfig& c) {
  v.Number({"accelerometer_time_constant_s", "Longer trusts the gyro longer; shorter follows the thrust's tilt."},
           c.accelerometer_time_constant_s, kSecond, kPositiveTime);
  v.Number({"gyro_bias_time_constant_s", "How fast the gyro's bias is learned."}, c.gyro_bias_time_constant_s, kSecond,
           kPositiveTime);
  v.Number({"initial_tilt_sigma_deg", "1-sigma of roll and pitch as the first sample shows them."},
           c.initial_tilt_sigma_rad, kDegree, kPositive);
  v.Number({"initial_gyro_bias_sigma_deg_s", "1-sigma of the gyro's bias at the start."},
           c.initial_gyro_bias_sigma_rad_s, kDegreePerSecond, kPositive);
  v.Number({"level_ground_tolerance_deg",
            "Ground on which the accelerometer at rest shows no more tilt is taken to be level; 0: never."},
           c.level_ground_tolerance_rad, kDegree, Between(0.0, 90.0));
  v.Number({"acceleration_tolerance", "A specific force that is this share of g off in size is not used."},
           c.acceleration_tolerance, kNoUnit, kPositive);
  v.Number({"yaw_time_constant_s", "How fast yaw follows vision."}, c.yaw_time_constant_s, kSecond, kPositiveTime);
  v.Number({"yaw_bias_time_constant_s", "How fast vision's yaw teaches the bias of the gyro's Z."},
           c.yaw_bias_time_constant_s, kSecond, kPositiveTime);
  v.Number({"history_s", "How late a camera frame may come."}, c.history_s, kSecond, PositiveUpTo(10.0));
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, estimator::PoseFilterConfig& c) {
  v.Number({"xy_acceleration_noise_m_s2_sqrt_hz", "Larger follows sooner, with more noise."},
           c.xy_acceleration_noise_m_s2_sqrt_hz, kMetrePerSecond2RootHertz, kPositive);
  v.Number({"z_acceleration_noise_m_s2_sqrt_hz", "Larger follows sooner, with more noise."},
           c.z_acceleration_noise_m_s2_sqrt_hz, kMetrePerSecond2RootHertz, kPositive);
  v.Number({"xy_noise_per_height", "1-sigma of a vision position, horizontally, per metre of height."},
           c.xy_noise_per_height, kNoUnit, kPositive);
  v.Number({"min_xy_noise_m", "What it is at least."}, c.min_xy_noise_m, kMetre, kPositive);
  v.Number({"z_noise_per_height", "The same vertically."}, c.z_noise_per_height, kNoUnit, kPositive);
  v.Number({"min_z_noise_m", "What it is at least."}, c.min_z_noise_m, kMetre, kPositive);
  v.Number({"initial_speed_m_s", "1-sigma of each component of the velocity at the first position."},
           c.initial_speed_m_s, kMetrePerSecond, kPositive);
  v.Check("", [&c] { c.Validate(); });
}

namespace {

void DescribeTakeoff(ConfigVisitor& v, controller::GuidanceConfig& c) {
  v.Number({"standby_s", "On the ground before takeoff, in which the IMU settles."}, c.standby_s, kSecond, kTime);
  v.Number({"start_thrust_ratio", "Thrust at the start of the blind climb, as a share of the weight."},
           c.start_thrust_ratio, kNoUnit, kNotNegative);
  v.Number({"thrust_ratio_rate_1_s", "How fast that share grows."}, c.thrust_ratio_rate_1_s, kPerSecond, kPositive);
  v.Number({"max_thrust_ratio", "Where it stops: the heaviest payload that takes off."}, c.max_thrust_ratio, kNoUnit,
           kPositive);
  v.Number({"blind_climb_limit_s", "How long a climb without the pad may last."}, c.blind_climb_limit_s, kSecond,
           kPositiveTime);
  v.Number({"blind_climb_limit_m", "How high it may go, by prediction."}, c.blind_climb_limit_m, kMetre, kPositive);
  v.Number({"climb_rate_m_s", "At which the set-point rises to the height of the takeoff."}, c.climb_rate_m_s,
           kMetrePerSecond, kPositive);
  v.Number({"arrival_error_m", "Height error at which the takeoff is done."}, c.arrival_error_m, kMetre, kPositive);
  v.Number({"ramp_limit_s", "How long the climb may take."}, c.ramp_limit_s, kSecond, kPositiveTime);
}

void DescribeLanding(ConfigVisitor& v, controller::GuidanceConfig& c) {
  v.Number({"cone_radius_m", "Of the cone Q' at its bottom. Wider lands sooner, further off."}, c.cone_radius_m, kMetre,
           kPositive);
  v.Number({"cone_half_angle_deg", "Of the cone Q'."}, c.cone_half_angle_rad, kDegree, Between(0.0, 80.0));
  v.Number({"h_err_m", "Height error at which a step counts as reached."}, c.h_err_m, kMetre, kPositive);
  v.Number({"t_0_s", "For how long the vehicle must have been in Q' with less height error than that."}, c.t_0_s,
           kSecond, kTime);
  v.Number({"h_step_m", "How far the set-point comes down in a step."}, c.h_step_m, kMetre, kPositive);
  v.Number({"step_rate_m_s", "At which it moves through a step."}, c.step_rate_m_s, kMetrePerSecond, kPositive);
  v.Number({"braking_m_s2", "And slows down towards the blind height by this much."}, c.braking_m_s2, kMetrePerSecond2,
           kPositive);
  v.Number({"landing_limit_s", "How long a landing may take."}, c.landing_limit_s, kSecond, kPositiveTime);
  v.Number({"blind_clearance_m", "Of the soles over the pad, below which the descent goes on by prediction."},
           c.blind_clearance_m, kMetre, kPositive);
  v.Number({"vision_floor_clearance_m", "Down to here a sighting still helps the blind descent."},
           c.vision_floor_clearance_m, kMetre, kNotNegative);
  v.Number({"blind_entry_speed_m_s", "No faster, in any direction, when the blind descent begins."},
           c.blind_entry_speed_m_s, kMetrePerSecond, kPositive);
  v.Number({"blind_descent_rate_m_s", "Of the blind descent."}, c.blind_descent_rate_m_s, kMetrePerSecond, kPositive);
  v.Number({"h_land_clearance_m", "Of the soles, by prediction, at which the motors go off."}, c.h_land_clearance_m,
           kMetre, Between(-1.0, 1.0));
}

void DescribeSearch(ConfigVisitor& v, controller::GuidanceConfig& c) {
  v.Number({"pad_lost_s", "Without a sighting, after which the pad counts as lost."}, c.pad_lost_s, kSecond,
           kPositiveTime);
  v.Number({"pad_found_s", "Of sightings, after which it counts as found again."}, c.pad_found_s, kSecond, kTime);
  v.Number({"hold_limit_s", "How long the vehicle stays where it is when the pad is lost."}, c.hold_limit_s, kSecond,
           kPositiveTime);
  v.Number({"search_climb_rate_m_s", "At which it then climbs to see more of the ground."}, c.search_climb_rate_m_s,
           kMetrePerSecond, kPositive);
  v.Number({"search_climb_limit_s", "How long it climbs before it gives up."}, c.search_climb_limit_s, kSecond,
           kPositiveTime);
  v.Number({"search_climb_m", "How far it climbs before it gives up, by prediction."}, c.search_climb_m, kMetre,
           kPositive);
}

}  // namespace

void Describe(ConfigVisitor& v, controller::GuidanceConfig& c) {
  DescribeTakeoff(v, c);
  DescribeLanding(v, c);
  DescribeSearch(v, c);
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, controller::PositionControllerConfig& c) {
  v.Number({"xy_position_gain_1_s", "Speed asked for per position error."}, c.xy_position_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"xy_velocity_gain_1_s", "Acceleration asked for per velocity error."}, c.xy_velocity_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"xy_integral_gain_1_s2", "Learns the trim against wind and a level error of the IMU."},
           c.xy_integral_gain_1_s2, {"1/s^2"}, kNotNegative);
  v.Number({"z_position_gain_1_s", "Speed asked for per height error."}, c.z_position_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"z_velocity_gain_1_s", "Acceleration asked for per velocity error."}, c.z_velocity_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"z_integral_gain_1_s2", "Learns the trim against an error of mass or thrust."}, c.z_integral_gain_1_s2,
           {"1/s^2"}, kNotNegative);
  v.Number({"max_xy_speed_m_s", "Of the speed asked for."}, c.max_xy_speed_m_s, kMetrePerSecond, kPositive);
  v.Number({"max_z_speed_m_s", "Of the speed asked for."}, c.max_z_speed_m_s, kMetrePerSecond, kPositive);
  v.Number({"max_tilt_deg", "Of the attitude asked for."}, c.max_tilt_rad, kDegree, PositiveUpTo(59.0));
  v.Number({"max_z_acceleration_m_s2", "Of the acceleration asked for."}, c.max_z_acceleration_m_s2, kMetrePerSecond2,
           kPositive);
  v.Number({"max_xy_integral_m_s2", "Of the trim."}, c.max_xy_integral_m_s2, kMetrePerSecond2, kPositive);
  v.Number({"max_z_integral_m_s2", "Of the trim."}, c.max_z_integral_m_s2, kMetrePerSecond2, kPositive);
  v.Number({"max_integrated_error_m_s", "Errors beyond it integrate as if they were this large."},
           c.max_integrated_error_m_s, kMetrePerSecond, kPositive);
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, controller::AttitudeControllerConfig& c) {
  v.Number({"roll_pitch_angle_gain_1_s", "Rate asked for per angle error."}, c.roll_pitch_angle_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"roll_pitch_rate_gain_1_s", "Angular acceleration asked for per rate error."}, c.roll_pitch_rate_gain_1_s,
           kPerSecond, kNotNegative);
  v.Number({"roll_pitch_rate_integral_gain_1_s2", "Takes out a constant torque."}, c.roll_pitch_rate_integral_gain_1_s2,
           {"1/s^2"}, kNotNegative);
  v.Number({"roll_pitch_rate_derivative_gain", "Against the angular acceleration: makes up for the rotor lag."},
           c.roll_pitch_rate_derivative_gain, kNoUnit, kNotNegative);
  v.Number({"derivative_cutoff_hz", "Of the low-pass before the derivative."}, c.derivative_cutoff_hz, kHertz,
           kPositive);
  v.Number({"max_roll_pitch_rate_deg_s", "Of the rate asked for."}, c.max_roll_pitch_rate_rad_s, kDegreePerSecond,
           kPositive);
  v.Number({"max_roll_pitch_integral_rad_s2", "Of what takes out a constant torque."}, c.max_roll_pitch_integral_rad_s2,
           kRadianPerSecond2, kPositive);
  v.Number({"yaw_angle_gain_1_s", "Rate asked for per angle error."}, c.yaw_angle_gain_1_s, kPerSecond, kNotNegative);
  v.Number({"yaw_rate_gain_1_s", "Angular acceleration asked for per rate error."}, c.yaw_rate_gain_1_s, kPerSecond,
           kNotNegative);
  v.Number({"yaw_rate_integral_gain_1_s2", "Takes out a constant torque."}, c.yaw_rate_integral_gain_1_s2, {"1/s^2"},
           kNotNegative);
  v.Number({"max_yaw_rate_deg_s", "Of the rate asked for."}, c.max_yaw_rate_rad_s, kDegreePerSecond, kPositive);
  v.Number({"max_yaw_integral_rad_s2", "Of what takes out a constant torque."}, c.max_yaw_integral_rad_s2,
           kRadianPerSecond2, kPositive);
  v.Check("", [&c] { c.Validate(); });
}

void Describe(ConfigVisitor& v, controller::FlightControllerConfig& c) {
  v.Text({"name", "Which controller flies."}, c.name);
  v.Check("name", [&c] { controller::RequireControllerName(c.name); });
  v.Keys({"guidance", "The set-points (Sec. V): takeoff, landing, and what happens when the pad is not seen."},
         c.guidance);
  v.Keys({"position", "The outer loop: position error to thrust and tilt."}, c.position);
  v.Keys({"attitude", "The inner loop: attitude error to torque."}, c.attitude);
  v.Number({"vision_fresh_s", "How old the newest sighting may be for vision's position to be used."}, c.vision_fresh_s,
           kSecond, kPositiveTime);
  v.Check("", [&c] { c.Validate(); });
}

}  // namespace touchdown::config
