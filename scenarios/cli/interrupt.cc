#include "scenarios/cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace touchdown::cli {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void Request(int) { requested = 1; }

}  // namespace

void CatchInterrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // Keep a signal ignored when the parent process ignores it, as nohup does with SIGHUP.
    if (std::signal(signal, Request) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

bool InterruptRequested() { return requested != 0; }

}  // namespace touchdown::cli
