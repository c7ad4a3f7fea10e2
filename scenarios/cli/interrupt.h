#pragma once

namespace touchdown::cli {

/// Installs handlers for Ctrl-C (SIGINT), SIGTERM and a closed terminal (SIGHUP) that record a stop request instead of
/// ending the program. A signal that the parent process ignores stays ignored.
void CatchInterrupts();

/// Whether a stop was requested since CatchInterrupts().
bool InterruptRequested();

}  // namespace touchdown::cli
