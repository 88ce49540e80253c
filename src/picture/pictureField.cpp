#include "picture/pictureField.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

namespace {

const std::vector<PictureField>& all() {
    using N = const Nodes<2>&;
    static const std::vector<PictureField> fields{
        {"p", "p [Pa]", Region::fluid, [](N n, int i) { return n.p[i]; }},
        {"U", "|U| [m/s]", Region::both, [](N n, int i) { return n.v[i].norm(); }},
        {"Ux", "Ux [m/s]", Region::both, [](N n, int i) { return n.v[i][0]; }},
        {"Uy", "Uy [m/s]", Region::both, [](N n, int i) { return n.v[i][1]; }},
        {"D", "|D| [m]", Region::both, [](N n, int i) { return (n.x[i] - n.X[i]).norm(); }},
        {"Dx", "Dx [m]", Region::both, [](N n, int i) { return n.x[i][0] - n.X[i][0]; }},
        {"Dy", "Dy [m]", Region::both, [](N n, int i) { return n.x[i][1] - n.X[i][1]; }},
        {"vonMises", "von Mises stress [Pa]", Region::solid, [](N n, int i) { return vonMises(n.sigma[i]); }},
        {"sigmaxx", "sigma xx [Pa]", Region::solid, [](N n, int i) { return n.sigma[i][0]; }},
        {"sigmayy", "sigma yy [Pa]", Region::solid, [](N n, int i) { return n.sigma[i][1]; }},
        {"sigmaxy", "sigma xy [Pa]", Region::solid, [](N n, int i) { return n.sigma[i][3]; }},
    };
    return fields;
}

}  // namespace

std::vector<std::string> pictureFieldNames() {
    std::vector<std::string> names;
    for (const auto& field : all()) names.push_back(field.name);
    return names;
}

const PictureField& pictureField(const std::string& name) {
    for (const auto& field : all())
        if (field.name == name) return field;
    throw UserError(notValid(name, "field", pictureFieldNames()));
}

double vonMises(const Stress<2>& s) {
    const double mean = (s[0] + s[1] + s[2]) / 3;
    const double xx = s[0] - mean, yy = s[1] - mean, zz = s[2] - mean;
    return std::sqrt(1.5 * (xx * xx + yy * yy + zz * zz + 2 * s[3] * s[3]));
}

}  // namespace pfem
