#pragma once
// `type volumeFlow`: how much fluid passes a plane.

#include <optional>

#include "dictionary/entries.hpp"
#include "functions/functionObject.hpp"
#include "functions/planeCut.hpp"
#include "io/table.hpp"

namespace pfem {

struct VolumeFlowEntries {
    Eigen::Vector3d point{0, 0, 0}, normal{1, 0, 0};

    template <class Visitor>
    void entries(Visitor& v) {
        v.required("point", point, "m", "of the plane (2D: of the line), which has no end");
        v.required("normal", normal, "-", "of the plane: what passes along it counts as positive");
    }
};

/// int v . n dA over what the plane cuts out of the fluid [m2/s (2D), m3/s]; exact for the linear v of the cells. Drops
/// in flight are not seen.
template <int Dim>
double volumeFlow(const State<Dim>& state, const Plane<Dim>& plane);

/// Writes postProcessing/<name>/<startTime>/volumeFlow.dat: time, the rate, and its integral over every step since the
/// beginning [m2 (2D), m3] by the trapezoidal rule (pfemPostProcess: over the written times).
template <int Dim>
class VolumeFlow : public FunctionObject<Dim> {
public:
    VolumeFlow(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void advance(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    std::vector<double> memory() const override { return {volume_}; }

private:
    FunctionContext<Dim> context_;
    Plane<Dim> plane_;
    double time_ = 0, rate_ = 0, volume_ = 0;
    std::optional<Table> table_;
};

}  // namespace pfem
