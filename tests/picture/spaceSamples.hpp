#pragma once
// Small states in space for pictures.

#include <map>

#include "state/state.hpp"

namespace pfem {

/// Adds a node; p = 10 x.
inline int addNode(State<3>& state, const Vec<3>& x) {
    const int i = state.nodes.size();
    state.nodes.resize(i + 1);
    state.nodes.x[i] = state.nodes.X[i] = x;
    state.nodes.p[i] = 10 * x[0];
    return i;
}

/// Adds a box of n^3 cubes of six tetrahedra each to the fluid or the solid.
inline void addBox(State<3>& state, Cells<3>& cells, const Vec<3>& low, const Vec<3>& high, int n = 3) {
    const int first = state.nodes.size(), row = n + 1;
    for (int k = 0; k < row * row * row; ++k) {
        const std::array<int, 3> at{k % row, k / row % row, k / row / row};
        const Vec<3> part = Vec<3>(at[0], at[1], at[2]) / n;
        addNode(state, low + part.cwiseProduct(high - low));
    }
    const int step[3] = {1, row, row * row};
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int k = 0; k < row * row * row; ++k) {
        if (k % row == n || k / row % row == n || k / row / row == n) continue;
        for (int o = 0; o < 6; ++o) {
            const int a = first + k, b = a + step[orders[o][0]], c = b + step[orders[o][1]], d = c + step[orders[o][2]];
            cells.nodes.push_back(o < 3 ? Simplex<3>{a, b, c, d} : Simplex<3>{a, c, b, d});
            cells.material.push_back(0);
        }
    }
}

/// A ball of fluid about the origin: an octahedron whose faces were divided `times` times, joined to the centre.
inline State<3> ball(double radius, int times) {
    State<3> state;
    const int centre = addNode(state, Vec<3>::Zero());
    std::vector<std::array<Vec<3>, 3>> faces;
    for (int k = 0; k < 8; ++k) {
        const Vec<3> x = (k & 1 ? -1 : 1) * Vec<3>::UnitX(), y = (k & 2 ? -1 : 1) * Vec<3>::UnitY(),
                     z = (k & 4 ? -1 : 1) * Vec<3>::UnitZ();
        const bool outwards = x[0] * y[1] * z[2] > 0;
        faces.push_back(outwards ? std::array<Vec<3>, 3>{x, y, z} : std::array<Vec<3>, 3>{x, z, y});
    }
    for (; times > 0; --times) {
        std::vector<std::array<Vec<3>, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const Vec<3> ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = finer;
    }
    std::map<std::array<double, 3>, int> nodes;
    const auto nodeAt = [&](const Vec<3>& x) {
        const auto [at, isNew] = nodes.try_emplace({x[0], x[1], x[2]}, state.nodes.size());
        if (isNew) addNode(state, radius * x);
        return at->second;
    };
    for (const auto& [a, b, c] : faces) {
        state.mesh.fluid.nodes.push_back({centre, nodeAt(a), nodeAt(b), nodeAt(c)});
        state.mesh.fluid.material.push_back(0);
    }
    return state;
}

}  // namespace pfem
