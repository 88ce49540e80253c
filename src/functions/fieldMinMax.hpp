#pragma once
// `type fieldMinMax`: the extremes of fields and where they are.

#include <optional>
#include <vector>

#include "functions/fields.hpp"
#include "functions/functionObject.hpp"
#include "io/table.hpp"

namespace pfem {

/// Writes postProcessing/<name>/<startTime>/fieldMinMax.dat, tab separated: one row per time and field with
/// the smallest and largest value (vectors and tensors: magnitude) over the nodes of the field's region;
/// points of walls are none.
template <int Dim>
class FieldMinMax : public FunctionObject<Dim> {
public:
    FieldMinMax(const Dictionary& dict, const FunctionContext<Dim>& context);

    void start(const State<Dim>& state) override;
    void execute(const State<Dim>& state) override;

private:
    FunctionContext<Dim> context_;
    std::vector<NodalField<Dim>> fields_;
    std::optional<Table> table_;
};

}  // namespace pfem
