#include "sim/dynamics/mujoco_errors.h"

#include <mujoco/mujoco.h>

#include <new>
#include <utility>

namespace touchdown::sim {
namespace {

thread_local std::optional<std::string> first_warning;

void KeepWarning(const char* message) {
  if (!first_warning) first_warning = message;
}

// MuJoCo's callers go on as if nothing had happened when this returns.
[[noreturn]] void ThrowError(const char* message) {
  RefuseLackOfMemory(message);
  throw SimulationError(std::string("MuJoCo: ") + message);
}

}  // namespace

void InstallMujocoHandlers() {
  [[maybe_unused]] static const bool installed = [] {
    mju_user_warning = KeepWarning;
    mju_user_error = ThrowError;
    return true;
  }();
}

void RefuseLackOfMemory(std::string_view message) {
  // "Could not allocate memory", "could not allocate buffers in hfield", ...
  if (message.find("ould not allocate") != std::string_view::npos) throw std::bad_alloc();
}

std::optional<std::string> TakeMujocoWarning() { return std::exchange(first_warning, std::nullopt); }

}  // namespace touchdown::sim
