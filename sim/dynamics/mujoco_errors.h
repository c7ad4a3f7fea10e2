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

/// Installs process-wide MuJoCo handlers, once. A warning is stored for PopMujocoWarning instead of being written to
/// MUJOCO_LOG.TXT. An error throws SimulationError, or std::bad_alloc if memory ran out, instead of ending the process.
void InstallMujocoHandlers();

/// Throws std::bad_alloc if `message` is one of MuJoCo's out-of-memory errors.
void ThrowIfOutOfMemory(std::string_view message);

/// Returns and clears the first warning that MuJoCo raised on this thread since the last call, or nullopt.
std::optional<std::string> PopMujocoWarning();

}  // namespace touchdown::sim
