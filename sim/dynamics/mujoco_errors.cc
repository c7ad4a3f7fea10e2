#include "sim/dynamics/mujoco_errors.h"

#include <mujoco/mujoco.h>

#include <new>
#include <utility>

namespace touchdown::sim {
namespace {

thread_local std::optional<std::string> first_warning;

void StoreWarning(const char* message) {
  if (!first_warning) first_warning = message;
}

// Must not return: MuJoCo would continue as if there were no error.
[[noreturn]] void ThrowError(const char* message) {
  ThrowIfOutOfMemory(message);
  throw SimulationError(std::string("MuJoCo: ") + message);
}

}  // namespace

void InstallMujocoHandlers() {
  [[maybe_unused]] static const bool installed = [] {
    mju_user_warning = StoreWarning;
    mju_user_error = ThrowError;
    return true;
  }();
}

void ThrowIfOutOfMemory(std::string_view message) {
  // "Could not allocate memory", "could not allocate buffers in hfield", ...
  if (message.find("ould not allocate") != std::string_view::npos) throw std::bad_alloc();
}

std::optional<std::string> PopMujocoWarning() { return std::exchange(first_warning, std::nullopt); }

}  // namespace touchdown::sim
