#pragma once
// `type pressureSensor`: the mean pressure over a small disc on a wall or on a solid's boundary.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "functions/sensorMean.hpp"
#include "functions/timeFilter.hpp"
#include "io/table.hpp"

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
          "what the pressure is averaged over: a disc (2D: across the plane, chords as weights) or, in 2D, a segment",
          oneOf({"disc", "segment"}));
        v("filter", filter, "-",
          "of the file pFiltered: none (no such file); lowPass: dS/dt = (p - S)/filterTime; movingAverage: "
          "mean over the last "
          "filterTime; both see every step, and a dry sensor as p = 0",
          oneOf(TimeFilter::kinds()));
        v("filterTime", filterTime, "s", "time constant or length of the window of the filter", positive);
    }
};

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
