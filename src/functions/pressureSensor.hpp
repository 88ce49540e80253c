#pragma once
// `type pressureSensor`: the mean pressure over a small disc on a wall or on a solid's boundary.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "functions/timeFilter.hpp"
#include "io/table.hpp"
#include "mesh/topology.hpp"

namespace pfem {

struct PressureSensorEntries {
    std::vector<Eigen::Vector3d> points;
    double width = 0;
    std::string shape = "disc";
    std::string filter = "none";
    double filterTime = 2e-3;

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("points", points, "m",
                   "centres of the sensors, on a wall or on the boundary of a solid; they ride on what they "
                   "are fixed to");
        v.required("width", width, "m", "diameter of the disc, length of the segment", positive);
        v("shape", shape, "-",
          "what the pressure is averaged over: a disc across the plane (chords as weights) or a segment",
          oneOf({"disc", "segment"}));
        v("filter", filter, "-",
          "of the file pFiltered: none (no such file); lowPass: dS/dt = (p - S)/filterTime; movingAverage: "
          "mean over the last "
          "filterTime; both see every step, and a dry sensor as p = 0",
          oneOf(TimeFilter::kinds()));
        v("filterTime", filterTime, "s", "time constant or length of the window of the filter", positive);
    }
};

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

/// Exact mean of the piecewise linear pressure of the wet faces in the sensor's plane.
template <int Dim>
SensorReading readSensor(const State<Dim>& state, const Topology<Dim>& topology, const SensorAnchor<Dim>& anchor,
                         double width, bool disc);

/// Writes postProcessing/<name>/<startTime>/p (a dry sensor gives -1e+300), wet (the part of each sensor that
/// the fluid touches) and, with a filter, pFiltered; in the form of OpenFOAM's probes.
template <int Dim>
class PressureSensor : public FunctionObject<Dim> {
public:
    PressureSensor(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void advance(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    std::vector<double> memory() const override;

private:
    void recall(const std::vector<double>& memory);

    Dictionary dict_;
    FunctionContext<Dim> context_;
    PressureSensorEntries entries_;
    std::vector<PatchKind> kinds_;
    std::vector<SensorAnchor<Dim>> anchors_;
    std::vector<SensorReading> readings_;
    std::vector<TimeFilter> filters_;
    std::optional<Table> p_, wet_, filtered_;
};

}  // namespace pfem
