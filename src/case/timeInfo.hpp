#pragma once
// Where a run is in time.

namespace pfem {

/// Time and step; what OpenFOAM keeps in <time>/uniform/time.
struct TimeInfo {
    double value = 0;    // [s]
    int index = 0;       // steps since the start
    double deltaT = 0;   // the step that led here [s]; of fixed steps what it should have been: longer when it was cut
    double deltaT0 = 0;  // the step that led here [s]
};

}  // namespace pfem
