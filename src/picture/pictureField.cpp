#include "picture/pictureField.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

template <int Dim>
using N = const Nodes<Dim>&;

/// "Ux" and the like: one component of a vector.
template <int Dim, int K>
std::vector<PictureField<Dim>> components(const std::string& axis) {
    return {{"U" + axis, "U" + axis + " [m/s]", Region::both, [](N<Dim> n, int i) { return n.v[i][K]; }},
            {"D" + axis, "D" + axis + " [m]", Region::both, [](N<Dim> n, int i) { return n.x[i][K] - n.X[i][K]; }}};
}

template <int Dim, int K>
PictureField<Dim> stress(const std::string& axes) {
    return {"sigma" + axes, "sigma " + axes + " [Pa]", Region::solid, [](N<Dim> n, int i) { return n.sigma[i][K]; }};
}

template <int Dim>
std::vector<PictureField<Dim>> makeAll() {
    const auto x = components<Dim, 0>("x"), y = components<Dim, 1>("y"), z = components<Dim, Dim - 1>("z");
    std::vector<PictureField<Dim>> fields{
        {"p", "p [Pa]", Region::fluid, [](N<Dim> n, int i) { return n.p[i]; }},
        {"U", "|U| [m/s]", Region::both, [](N<Dim> n, int i) { return n.v[i].norm(); }},
        x[0],
        y[0],
        {"D", "|D| [m]", Region::both, [](N<Dim> n, int i) { return (n.x[i] - n.X[i]).norm(); }},
        x[1],
        y[1],
        {"vonMises", "von Mises stress [Pa]", Region::solid, [](N<Dim> n, int i) { return vonMises<Dim>(n.sigma[i]); }},
        stress<Dim, 0>("xx"),
        stress<Dim, 1>("yy"),
        stress<Dim, 3>("xy"),
        {"none", "", Region::both, nullptr},
    };
    if constexpr (Dim == 3)
        for (const auto& field : {z[0], z[1], stress<3, 2>("zz"), stress<3, 4>("yz"), stress<3, 5>("xz")})
            fields.insert(fields.end() - 1, field);
    return fields;
}

template <int Dim>
const std::vector<PictureField<Dim>>& all() {
    static const std::vector<PictureField<Dim>> fields = makeAll<Dim>();
    return fields;
}

}  // namespace

template <int Dim>
std::vector<std::string> pictureFieldNames() {
    std::vector<std::string> names;
    for (const auto& field : all<Dim>()) names.push_back(field.name);
    return names;
}

template <int Dim>
const PictureField<Dim>& pictureField(const std::string& name) {
    for (const auto& field : all<Dim>())
        if (field.name == name) return field;
    throw UserError(notValid(name, "field", pictureFieldNames<Dim>()));
}

template <int Dim>
double vonMises(const Stress<Dim>& s) {
    const double mean = (s[0] + s[1] + s[2]) / 3;
    const double xx = s[0] - mean, yy = s[1] - mean, zz = s[2] - mean;
    const double shear = s.template tail<nStress<Dim> - 3>().squaredNorm();
    return std::sqrt(1.5 * (xx * xx + yy * yy + zz * zz + 2 * shear));
}

#define PFEM_INSTANTIATE(D)                                              \
    template std::vector<std::string> pictureFieldNames<D>();            \
    template const PictureField<D>& pictureField<D>(const std::string&); \
    template double vonMises<D>(const Stress<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
