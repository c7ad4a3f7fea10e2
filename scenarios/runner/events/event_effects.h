#pragma once

#include <Eigen/Core>
#include <optional>

namespace touchdown::runner {

/// Time of an event at one tick.
struct EventTime {
  bool begins = false;      ///< Whether it is the first tick of the event.
  double elapsed_s = 0.0;   ///< Since the start of the event.
  double duration_s = 0.0;  ///< Not used by kinds without a duration.
};

/// The effects of all events of a flight at one tick. Each event adds its own.
struct EventEffects {
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();     ///< Force in W at the body's origin.
  Eigen::Vector3d torque_n_m = Eigen::Vector3d::Zero();  ///< Torque in W.
  std::optional<Eigen::Vector3d> mean_wind_m_s = {};     ///< New mean wind in W; nullopt: unchanged.
  Eigen::Vector3d gust_m_s = Eigen::Vector3d::Zero();    ///< Velocity in W that is added to the mean wind.
  bool pad_is_covered = false;
  bool frames_are_lost = false;
};

}  // namespace touchdown::runner
