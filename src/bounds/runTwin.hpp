#pragma once
// The computation of a twin: pfemMesh and pfemFsiFoam as child processes in its folder.

#include <iosfwd>

#include "bounds/twinCase.hpp"

namespace pfem {

/// Mesh the twin if it has no time folder yet and run it to its endTime, from where it is; a finished one is
/// left alone. Every 15 s the progress that its log tells goes to `out`. Throws UserError, also when SIGINT
/// or SIGTERM stopped it.
void runTwin(const TwinCase& twin, std::ostream& out);

}  // namespace pfem
