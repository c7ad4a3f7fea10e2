#include "scenarios/runner/flight_tables.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "scenarios/runner/tum_trajectory.h"
#include "scenarios/util/csv_writer.h"
#include "scenarios/util/sha256.h"

namespace touchdown::runner {
namespace {

constexpr std::string_view kFlightHeader =
    "tick,t_s,phase,"
    "true_x_m,true_y_m,true_z_m,true_roll_deg,true_pitch_deg,true_yaw_deg,"
    "true_vx_m_s,true_vy_m_s,true_vz_m_s,true_wx_deg_s,true_wy_deg_s,true_wz_deg_s,gear_in_contact,"
    "est_x_m,est_y_m,est_z_m,est_vx_m_s,est_vy_m_s,est_vz_m_s,"
    "est_roll_deg,est_pitch_deg,est_yaw_deg,est_wx_deg_s,est_wy_deg_s,est_wz_deg_s,pad_seen_tick,"
    "used_x_m,used_y_m,used_z_m,used_vx_m_s,used_vy_m_s,used_vz_m_s,used_is_predicted,"
    "set_x_m,set_y_m,set_z_m,set_roll_deg,set_pitch_deg,set_yaw_deg,thrust_n,torque_x_n_m,torque_y_n_m,torque_z_n_m,"
    "command0_rad_s,command1_rad_s,command2_rad_s,command3_rad_s,"
    "rotor0_rad_s,rotor1_rad_s,rotor2_rad_s,rotor3_rad_s";

constexpr std::string_view kFramesHeader =
    "tick,t_s,delivered_tick,phase,status,"
    "x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,"
    "true_x_m,true_y_m,true_z_m,true_roll_deg,true_pitch_deg,true_yaw_deg,"
    "ring_in_view,pad_u_px,pad_v_px,true_pad_u_px,true_pad_v_px,"
    "cov_x_x,cov_x_y,cov_x_z,cov_x_rx,cov_x_ry,cov_x_rz,cov_y_y,cov_y_z,cov_y_rx,cov_y_ry,cov_y_rz,"
    "cov_z_z,cov_z_rx,cov_z_ry,cov_z_rz,cov_rx_rx,cov_rx_ry,cov_rx_rz,cov_ry_ry,cov_ry_rz,cov_rz_rz";

void PutCovariance(util::CsvWriter& table, const Eigen::Matrix<double, 6, 6>& covariance) {
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column) table << covariance(row, column);
  }
}

void PutTicks(const FlightLog& log, util::CsvWriter& table) {
  for (const TickRecord& record : log.ticks) {
    const sim::TrueState& truth = record.truth;
    const models::VehicleEstimate& estimate = record.estimate;
    const controller::ControlOutput& control = record.control;
    table << truth.tick << log.time.ToSeconds(truth.tick) << Name(control.phase);
    table.Pose(truth.X_WB).Vector(truth.v_WB).Rates(truth.w_WB_B) << static_cast<int>(truth.gear_in_contact);
    if (estimate.motion) {
      table.Vector(estimate.motion->p_WB).Vector(estimate.motion->v_WB);
    } else {
      table.Empty(6);
    }
    table.Angles(estimate.attitude).Rates(estimate.w_WB_B);
    estimate.pad_seen ? table << *estimate.pad_seen : table.Empty(1);
    table.Vector(control.motion.p_WB).Vector(control.motion.v_WB) << static_cast<int>(control.motion_is_predicted);
    table.Vector(control.set_point_m).Angles(control.attitude_set_point) << control.thrust_n;
    table.Vector(control.torque_n_m);
    for (const double speed : control.rotors.speed_rad_s) table << speed;
    for (const double speed : truth.rotor_speed_rad_s) table << speed;
    table.EndLine();
  }
}

void PutFrames(const FlightLog& log, util::CsvWriter& table) {
  for (const FrameRecord& frame : log.frames) {
    table << frame.mid_exposure << log.time.ToSeconds(frame.mid_exposure) << frame.delivered << Name(frame.phase)
          << estimator::ReasonOrStatus(frame.status, frame.reason);
    frame.pose ? table.Pose(frame.pose->X_WB) : table.Empty(6);
    table.Pose(frame.X_WB) << static_cast<int>(frame.ring_in_view);
    table.Pixel(frame.pad_px).Pixel(frame.true_pad_px);
    if (frame.pose) {
      PutCovariance(table, frame.pose->covariance);
    } else {
      table.Empty(21);
    }
    table.EndLine();
  }
}

template <typename Sensor>
NamedText SensorTable(const FlightLog& log) {
  util::CsvWriter table(fmt::format("tick,t_s,{},true_x_m,true_y_m,true_z_m,true_roll_deg,true_pitch_deg,true_yaw_deg",
                                    Sensor::kColumns));
  for (const SensorRecord<Sensor>& record : log.Records<Sensor>()) {
    table << record.reading.tick << log.time.ToSeconds(record.reading.tick);
    for (const double value : Sensor::Columns(record.reading)) table << value;
    table.Pose(record.X_WB).EndLine();
  }
  return {std::string(Sensor::kName) + ".csv", table.Take()};
}

template <typename... Sensor>
std::vector<NamedText> TablesOf(SensorList<Sensor...>, const FlightLog& log) {
  return {SensorTable<Sensor>(log)...};
}

}  // namespace

std::string FlightCsv(const FlightLog& log) {
  util::CsvWriter table(kFlightHeader);
  PutTicks(log, table);
  return table.Take();
}

std::string FramesCsv(const FlightLog& log) {
  util::CsvWriter table(kFramesHeader);
  PutFrames(log, table);
  return table.Take();
}

std::vector<NamedText> SensorTables(const FlightLog& log) { return TablesOf(LoggedSensors(), log); }

std::string FrameTimingCsv(const FlightLog& log) {
  util::CsvWriter table("tick,render_ms,vision_ms,geometry_ms");
  for (const FrameRecord& frame : log.frames) {
    table << frame.mid_exposure << frame.render_ms << frame.vision_ms << frame.geometry_ms;
    table.EndLine();
  }
  return table.Take();
}

std::vector<NamedText> WriteTables(const FlightLog& log) {
  std::vector<NamedText> tables{{"flight.csv", FlightCsv(log)},
                                {"frames.csv", FramesCsv(log)},
                                {"frame_timing.csv", FrameTimingCsv(log)},
                                {"truth.tum", TumText(TrueTrajectory(log), log.time)},
                                {"estimate.tum", TumText(EstimatedTrajectory(log), log.time)},
                                {"tracking.tum", TumText(TrackedTrajectory(log), log.time)}};
  for (NamedText& table : SensorTables(log)) tables.push_back(std::move(table));
  return tables;
}

std::string LogDigest(const FlightLog& log) {
  util::Sha256Stream digest;
  const util::TextSink sink = [&digest](std::string_view piece) { digest.Add(piece); };
  util::CsvWriter ticks(kFlightHeader, sink), frames(kFramesHeader, sink);
  PutTicks(log, ticks);
  ticks.Take();
  PutFrames(log, frames);
  frames.Take();
  return digest.Finish();
}

}  // namespace touchdown::runner
