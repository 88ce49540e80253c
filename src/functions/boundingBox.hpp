#pragma once
// `type boundingBox`: where fluid and solids end.

#include <optional>

#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

/// Writes postProcessing/<name>/<startTime>/boundingBox.dat: time, lower and upper corner of the fluid
/// (isolated drops included) and of the solids; -1e+300 for what there is not.
template <int Dim>
class BoundingBox : public FunctionObject<Dim> {
public:
    BoundingBox(const Dictionary&, const FunctionContext<Dim>& context) : context_(context) {}

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    std::optional<Table> table_;
};

}  // namespace pfem
