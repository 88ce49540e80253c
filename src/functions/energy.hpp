#pragma once
// `type energy`: where the energy is, what has come in, what has gone.

#include <optional>

#include "functions/functionObject.hpp"
#include "functions/storedEnergy.hpp"
#include "io/table.hpp"

namespace pfem {

/// Integrals over time since the beginning [J/m (2D), J].
struct EnergyFlows {
    double viscous = 0;    // dissipated in the fluid
    double damper = 0;     // dissipated by the solids' zig-zag damper
    double workWalls = 0;  // done by moving walls and clamps
    double workLoads = 0;  // done by tractions, by the force that holds a flow through periodic sides, and in a frame
                           // by what it gets faster by
};

/// Writes postProcessing/<name>/<startTime>/energy.dat [J/m (2D), J]: kinetic, elastic (solids, and what
/// compresses the fluid), potential (- sum m g . x), total, the EnergyFlows, what the solver has counted as brought in
/// by remeshing (new connectivity, landing on walls) and by volume (lost by the equations, returned), and
///   numerical = total(0) + work + remeshing + volume - total - viscous - damper:
/// for solids the error of the balance, for fluids what time integration, stabilisation and the iteration
/// dissipate. Potential and total are those of gravity at the start: where it varies its work is in `numerical`.
/// Flows are integrated by the trapezoidal rule over every step (pfemPostProcess: over the written times).
template <int Dim>
class Energy : public FunctionObject<Dim> {
public:
    Energy(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void advance(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;
    std::vector<double> memory() const override;
    bool usesThreads() const override { return true; }

private:
    FunctionContext<Dim> context_;
    std::optional<Problem<Dim>> problem_;
    Controls controls_;
    double first_ = 0;                             // total(0)
    double firstRemeshing_ = 0, firstVolume_ = 0;  // the solver's counts at that time
    EnergyFlows flows_;
    double time_ = 0;
    EnergyPowers powers_;  // at time_
    std::vector<Id> ids_;  // at time_, for the work of loads
    Points<Dim> x_, loads_;
    std::optional<Table> table_;
};

}  // namespace pfem
