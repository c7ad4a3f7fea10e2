#pragma once

namespace touchdown::scenarios {

/// Makes Ctrl-C (SIGINT) and SIGTERM ask the program to stop instead of ending it at once.
void CatchInterrupts();

/// Whether the user has asked the program to stop.
bool InterruptRequested();

}  // namespace touchdown::scenarios
