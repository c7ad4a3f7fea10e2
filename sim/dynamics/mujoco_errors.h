#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace touchdown::sim {

/// Failure of the simulation: a MuJoCo warning, a number that is not finite, time running backwards. The flight ends
/// with outcome error, and the program with status 3.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes over MuJoCo's process-wide handlers, once: a warning is stored for TakeMujocoWarning instead of being written
/// to MUJOCO_LOG.TXT, and instead of ending the process, an error throws SimulationError, or std::bad_alloc.
void InstallMujocoHandlers();

/// Throws std::bad_alloc for MuJoCo's out-of-memory error.
void RefuseLackOfMemory(std::string_view message);

/// The first warning that MuJoCo raised on this thread since the last call; nullopt when there was none.
std::optional<std::string> TakeMujocoWarning();

}  // namespace touchdown::sim
