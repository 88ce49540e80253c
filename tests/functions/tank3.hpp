#pragma once
// Water in a box of five walls in space: a case folder and its state.

#include "caseFolder.hpp"
#include "io/surfaceSeries.hpp"
#include "support/cases3.hpp"

namespace pfem::test {

inline const char* const tank3Conditions =
    "floor { type slip; } left { type slip; } right { type slip; } sides { type slip; }";
inline const char* const tank3Gravity = "(0 0 -10)";
inline const char* const water3 = "water { type newtonian; rho 1000; mu 1e-3; kappa 2.1e9; }";

/// Water 1 m x 0.6 m x 0.5 m in a tank 0.8 m high; hydrostatic pressure for g = 10 along -z. The walls are
/// floor, left (x = 0), right (x = 1), sides.
inline State<3> tank3(double h = 0.1, double jitter = 0.2) {
    State<3> state = boxOfWater({1, 0.6, 0.5}, {1, 0.6, 0.8}, h, "slip", 1e-3, jitter).state;
    const auto all = state.mesh.patches[0].faces;
    state.mesh.patches = {{"floor", {}}, {"left", {}}, {"right", {}}, {"sides", {}}};
    for (const auto& face : all) {
        const Vec<3> area = faceArea<3>(state.nodes.x, face);
        state.mesh.patches[area[2] < 0 ? 0 : area[0] < 0 ? 1 : area[0] > 0 ? 2 : 3].faces.push_back(face);
    }
    for (auto& supports : state.nodes.wall) supports.fill(-1);
    separateFromWalls<3>({true, true, true, true}, state);
    for (int i = 0; i < state.nodes.size(); ++i) state.nodes.p[i] = 1e4 * (0.5 - state.nodes.x[i][2]);
    return state;
}

/// Area of a surface [m2], of lines their length [m].
inline double sizeOf(const FieldSurface& surface) {
    double sum = 0;
    for (const auto& cell : surface.cells) {
        const Vec<3> a = surface.x[cell[0]];
        if (cell.size() == 2) sum += (surface.x[cell[1]] - a).norm();
        for (std::size_t k = 1; k + 1 < cell.size(); ++k)
            sum += 0.5 * Vec<3>(surface.x[cell[k]] - a).cross(Vec<3>(surface.x[cell[k + 1]] - a)).norm();
    }
    return sum;
}

}  // namespace pfem::test
