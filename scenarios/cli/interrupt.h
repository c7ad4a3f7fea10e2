#pragma once

namespace touchdown::cli {

/// Makes Ctrl-C (SIGINT), SIGTERM and a terminal that closes (SIGHUP) ask the program to stop instead of ending it at
/// once.
void CatchInterrupts();

/// Whether the user has asked the program to stop.
bool InterruptRequested();

}  // namespace touchdown::cli
