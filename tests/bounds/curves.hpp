#pragma once
// Closed-form curves: u(t) + a h^q (nodal) and u(t) - b h^q (elemental), in parts of u.

#include <cmath>
#include <functional>

#include "bounds/band.hpp"

namespace pfem::test {

inline std::vector<double> times(double end, int n) {
    std::vector<double> t;
    for (int i = 0; i <= n; ++i) t.push_back(end * i / n);
    return t;
}

/// nodal = u (1 + a h^q), elemental = u (1 - b h^q) for each mesh size.
inline Study powerLaw(const std::vector<double>& t, const std::function<double(double)>& u,
                      const std::vector<double>& sizes, double a, double b, double q) {
    Study study{t, {}};
    for (const double h : sizes) {
        Twin twin{h, {}, {}};
        for (const double now : t) {
            twin.nodal.push_back(u(now) * (1 + a * std::pow(h, q)));
            twin.elemental.push_back(u(now) * (1 - b * std::pow(h, q)));
        }
        study.twins.push_back(twin);
    }
    return study;
}

/// nodal(t), elemental(t) on one mesh.
inline Study pair(const std::vector<double>& t, const std::function<double(double)>& nodal,
                  const std::function<double(double)>& elemental, double h = 1) {
    Study study{t, {{h, {}, {}}}};
    for (const double now : t) {
        study.twins[0].nodal.push_back(nodal(now));
        study.twins[0].elemental.push_back(elemental(now));
    }
    return study;
}

}  // namespace pfem::test
