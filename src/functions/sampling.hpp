#pragma once
// Values of fields at a point.

#include <optional>

#include "dictionary/dictionary.hpp"
#include "functions/fields.hpp"
#include "mesh/locate.hpp"

namespace pfem {

/// Where a point lies: in the fluid, in a solid, in both (on their interface), or in neither.
template <int Dim>
struct Samples {
    std::optional<WeightedNodes<Dim>> inFluid, inSolid;
};

template <int Dim>
Samples<Dim> sampleAt(const State<Dim>& state, const Vec<Dim>& point);

/// Linear in the triangle; of the fluid or else of the solid, as the field has a meaning there; else
/// `outside` in every component.
template <int Dim>
std::vector<double> sampledValue(const NodalField<Dim>& field, const Nodes<Dim>& nodes, const Samples<Dim>& at,
                                 double outside);

/// The fields of the entry `fields`. Throws UserError with the valid names.
template <int Dim>
std::vector<NodalField<Dim>> nodalFields(const Dictionary& dict, const std::vector<std::string>& names);

}  // namespace pfem
