#pragma once
// The mean pressure over a sensor that is fixed to a face of a wall or of a solid.

#include "mesh/topology.hpp"
#include "state/state.hpp"

namespace pfem {

/// Where a sensor is fixed: a face by its nodes' ids, which last, and the place in it.
template <int Dim>
struct SensorAnchor {
    std::array<Id, Dim> ids{};
    Eigen::Matrix<double, Dim, 1> weights = Eigen::Matrix<double, Dim, 1>::Zero();
    bool onSolid = false;
};

/// Mean over one sensor; the part of it that the fluid does not touch counts with p = 0.
struct SensorReading {
    double p = 0;    // [Pa]
    double wet = 0;  // weighted part that the fluid touches, 0 to 1
};

/// Fix a sensor to the nearest face of a wall (positions x) or of a solid's boundary (reference positions X);
/// also gives the distance to it [m].
template <int Dim>
std::pair<SensorAnchor<Dim>, double> fixSensor(const State<Dim>& initial, const std::vector<PatchKind>& kinds,
                                               const Vec<Dim>& point);

/// The face that a sensor is fixed to, and its centre.
template <int Dim>
std::pair<Face<Dim>, Vec<Dim>> placeOf(const SensorAnchor<Dim>& anchor, const Nodes<Dim>& nodes);

/// Exact mean of the piecewise linear pressure of the wet faces in the sensor's line (2D: weighted by the chords of a
/// disc, or evenly over a segment) or plane (3D: a disc, onto which the wet triangles around are projected).
template <int Dim>
SensorReading readSensor(const State<Dim>& state, const Topology<Dim>& topology, const SensorAnchor<Dim>& anchor,
                         double width, bool disc);

}  // namespace pfem
