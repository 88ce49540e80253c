#pragma once
// Ctrl-C and kill: the run writes its state and stops.

namespace pfem {

/// From now on the first SIGINT or SIGTERM only sets a flag; the second ends the program at once.
void catchInterrupts();

/// Has a SIGINT or SIGTERM arrived?
bool interrupted();

/// Forget it (tests).
void clearInterrupt();

}  // namespace pfem
