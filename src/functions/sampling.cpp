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

#define PFEM_INSTANTIATE(D)                                                                                         \
    template Samples<D> sampleAt<D>(const State<D>&, const Vec<D>&);                                                \
    template std::vector<double> sampledValue<D>(const NodalField<D>&, const Nodes<D>&, const Samples<D>&, double); \
    template std::vector<NodalField<D>> nodalFields<D>(const Dictionary&, const std::vector<std::string>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
