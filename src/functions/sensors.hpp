#pragma once
// What functions that watch places have in common: columns per place, and a value for the dry.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

/// What stands in a table where there is no material: OpenFOAM's -VGREAT, told apart from every value.
inline constexpr double dry = -1e300;

/// A table in the form of OpenFOAM's probes, postProcessing/<name>/<startTime>/<file>: the places in the
/// head, one column each. `word`: what a place is called there ("Probe"); `found`: false marks it as "Not
/// Found".
/// In a plane case the place's z is not heeded: a warning where it is not zero.
template <int Dim>
void warnOutOfPlane(const Dictionary& dict, const std::string& key, const std::vector<Eigen::Vector3d>& points);

template <int Dim>
Table sensorTable(const FunctionContext<Dim>& context, const std::string& file, const std::string& word,
                  const std::vector<Eigen::Vector3d>& points, const std::vector<bool>& found = {});

/// A row: the time and one number per place.
void sensorRow(Table& table, double time, const std::vector<double>& values);

}  // namespace pfem
