#include "scenarios/cli/interrupt.h"

#include <csignal>

namespace touchdown::scenarios {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void Request(int) { requested = 1; }

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, Request);
  std::signal(SIGTERM, Request);
}

bool InterruptRequested() { return requested != 0; }

}  // namespace touchdown::scenarios
