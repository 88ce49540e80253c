#pragma once
// Ctrl-C and kill: the run writes its state and stops.

namespace pfem {

/// From now on the first SIGINT, SIGTERM or (unless it is ignored, as under nohup) SIGHUP only sets a flag; the second
/// ends the program at once. A log that nobody reads any more (SIGPIPE) does not end it.
void catchInterrupts();

/// The signal that has arrived; 0: none.
int interrupted();

/// "SIGTERM"
const char* signalName(int number);

/// Forget it (tests).
void clearInterrupt();

}  // namespace pfem
