#pragma once
// `type periodicFlow`: what goes through periodic sides, and the body force that holds it.

#include <optional>

#include "functions/functionObject.hpp"
#include "io/table.hpp"
#include "solver/setup.hpp"

namespace pfem {

/// int v dV over the cells that count [m3/s (2D), m4/s], and their volume [m2 (2D), m3].
template <int Dim>
struct FluidFlow {
    Vec<Dim> integral = Vec<Dim>::Zero();
    double volume = 0;
};
template <int Dim>
FluidFlow<Dim> fluidFlow(const State<Dim>& state);

/// Writes postProcessing/<name>/<startTime>/periodicFlow.dat: the flow rate through the sides of each direction, the
/// mean over all sections between them [m2/s (2D), m3/s], the mean velocity [m/s], and the acceleration by which the
/// flow is held, driveOf() [m/s2].
template <int Dim>
class PeriodicFlow : public FunctionObject<Dim> {
public:
    PeriodicFlow(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    Location where_;  // of the function in controlDict
    std::optional<Problem<Dim>> problem_;
    Controls controls_;
    std::optional<Table> table_;
};

}  // namespace pfem
