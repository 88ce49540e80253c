#include "functions/fields.hpp"

#include "base/error.hpp"
#include "base/vectors.hpp"

namespace pfem {

namespace {

/// From xx yy zz xy (yz xz) to xx xy xz yy yz zz.
template <int Dim>
std::vector<double> symmTensor(const Stress<Dim>& s) {
    constexpr int last = nStress<Dim> - 1;
    const double yz = Dim == 3 ? s[last - 1] : 0.0;
    const double xz = Dim == 3 ? s[last] : 0.0;
    return {s[0], s[3], xz, s[1], yz, s[2]};
}

template <int Dim>
const std::vector<NodalField<Dim>>& allFields() {
    using N = const Nodes<Dim>&;
    static const std::vector<NodalField<Dim>> fields{
        {"U", 3, Region::both, [](N n, int i) { return threeNumbers<Dim>(n.v[i]); }},
        {"a", 3, Region::both, [](N n, int i) { return threeNumbers<Dim>(n.a[i]); }},
        {"D", 3, Region::both, [](N n, int i) { return threeNumbers<Dim>(n.x[i] - n.X[i]); }},
        {"p", 1, Region::fluid, [](N n, int i) { return std::vector<double>{n.p[i]}; }},
        {"sigma", 6, Region::solid, [](N n, int i) { return symmTensor<Dim>(n.sigma[i]); }},
        {"h", 1, Region::both, [](N n, int i) { return std::vector<double>{n.h[i]}; }},
    };
    return fields;
}

}  // namespace

template <int Dim>
const NodalField<Dim>& nodalField(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& field : allFields<Dim>()) {
        if (field.name == name) return field;
        names.push_back(field.name);
    }
    throw UserError(notValid(name, "field", names));
}

#define PFEM_INSTANTIATE(D) template const NodalField<D>& nodalField<D>(const std::string&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
