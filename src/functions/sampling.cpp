#include "functions/sampling.hpp"

#include "base/error.hpp"

namespace pfem {

template <int Dim>
Samples<Dim> sampleAt(const State<Dim>& state, const Vec<Dim>& point) {
    return {locate<Dim>(state.mesh.fluid, state.nodes.x, point), locate<Dim>(state.mesh.solid, state.nodes.x, point)};
}

template <int Dim>
std::vector<double> sampledValue(const NodalField<Dim>& field, const Nodes<Dim>& nodes, const Samples<Dim>& at,
                                 double outside) {
    const auto& place = at.inFluid && field.region != Region::solid ? at.inFluid : at.inSolid;
    const bool inside = place && (&place == &at.inFluid || field.region != Region::fluid);
    if (!inside) return std::vector<double>(static_cast<std::size_t>(field.components), outside);
    std::vector<double> sum(static_cast<std::size_t>(field.components), 0.0);
    for (int i = 0; i <= Dim; ++i) {
        const auto value = field.value(nodes, place->nodes[i]);
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += place->weights[i] * value[c];
    }
    return sum;
}

template <int Dim>
std::vector<NodalField<Dim>> nodalFields(const Dictionary& dict, const std::vector<std::string>& names) {
    std::vector<NodalField<Dim>> fields;
    for (const auto& name : names) {
        try {
            fields.push_back(nodalField<Dim>(name));
        } catch (const UserError& error) {
            dict.fatal("fields", error.what());
        }
    }
    return fields;
}

template Samples<2> sampleAt<2>(const State<2>&, const Vec<2>&);
template std::vector<double> sampledValue<2>(const NodalField<2>&, const Nodes<2>&, const Samples<2>&, double);
template std::vector<NodalField<2>> nodalFields<2>(const Dictionary&, const std::vector<std::string>&);

}  // namespace pfem
