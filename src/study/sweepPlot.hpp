#pragma once
// The picture of a study as a gnuplot script.

#include <string>
#include <vector>

#include "study/sweepCases.hpp"

namespace pfem {

/// A script that draws results.png in the folder in which gnuplot runs: a row of panels per result, in it a panel per
/// parameter. With several parameters the colour of a point is the value of the next one. Words are spaced evenly.
std::string sweepPlot(const Sweep& sweep, const std::vector<SweepRow>& rows);

}  // namespace pfem
