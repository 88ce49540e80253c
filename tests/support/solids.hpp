#pragma once
// What tests of solids that meet ask of a case.

#include <Eigen/Geometry>
#include <set>

#include "functions/storedEnergy.hpp"
#include "momentum/mass.hpp"
#include "support/cases.hpp"

namespace pfem::test {

inline std::string point(double x, double y) { return "(" + std::to_string(x) + " " + std::to_string(y) + ") "; }

/// Vertices of a rectangle, turned by `angle` about the origin.
inline std::string turned(double angle, double x0, double y0, double x1, double y1) {
    std::string text = "vertices (";
    for (const Vec<2>& p : {Vec<2>(x0, y0), Vec<2>(x1, y0), Vec<2>(x1, y1), Vec<2>(x0, y1)}) {
        const Vec<2> q = Eigen::Rotation2Dd(angle) * p;
        text += point(q[0], q[1]);
    }
    return text + ");";
}

inline std::set<int> nodesOf(const TestCase& c, const std::string& material) {
    std::set<int> nodes;
    for (int e = 0; e < c.state.mesh.solid.size(); ++e)
        if (c.state.mesh.materials[c.state.mesh.solid.material[e]] == material)
            nodes.insert(c.state.mesh.solid.nodes[e].begin(), c.state.mesh.solid.nodes[e].end());
    return nodes;
}

/// Mean of what the nodes of a material have.
inline Vec<2> meanOf(const TestCase& c, const Points<2>& value, const std::string& material) {
    const auto nodes = nodesOf(c, material);
    Vec<2> sum = Vec<2>::Zero();
    for (const int i : nodes) sum += value[i];
    return sum / static_cast<double>(nodes.size());
}

/// Bring a solid by `shift` to another place, its reference positions, too.
inline void displace(TestCase& c, const std::string& material, const Vec<2>& shift) {
    for (const int i : nodesOf(c, material)) {
        c.state.nodes.x[i] += shift;
        c.state.nodes.X[i] += shift;
    }
}

/// How deep the deepest node of a solid is behind the walls' lines, in parts of its h: for tanks that are convex.
inline double depthInWalls(const TestCase& c) {
    const auto topology = c.topology();
    double deepest = 0;
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (!topology.onSolid[i]) continue;
        for (const auto& wall : topology.walls)
            if (wall.patch >= 0)
                deepest = std::max(deepest, -inwardNormal<2>(c.state.nodes.x, wall.nodes)
                                                    .dot(c.state.nodes.x[i] - c.state.nodes.x[wall.nodes[0]]) /
                                                c.state.nodes.h[i]);
    }
    return deepest;
}

/// How deep the deepest node of a solid is in another body's cell, in parts of its h.
inline double depthInSolids(const TestCase& c) {
    const auto& [x, h] = std::tie(c.state.nodes.x, c.state.nodes.h);
    double deepest = 0;
    for (const auto& cell : c.state.mesh.solid.nodes)
        for (const auto& other : c.state.mesh.solid.nodes)
            for (const int i : other) {
                if (std::find(cell.begin(), cell.end(), i) != cell.end()) continue;
                const auto geometry = simplexGeometry<2>(x, cell);
                double inside = 1e300;  // distance to the nearest of the cell's lines
                for (int k = 0; k < 3; ++k) {
                    const auto& gradN = geometry.gradN[k];
                    const double N = gradN.dot(x[i] - x[cell[(k + 1) % 3]]);
                    inside = std::min(inside, N / gradN.norm());
                }
                deepest = std::max(deepest, inside / h[i]);
            }
    return deepest;
}

/// Kinetic and elastic energy of solids alone.
inline double solidEnergy(const TestCase& c) {
    const auto mass = solidMass<2>(c.problem, c.state.mesh.solid, c.state.nodes.X);
    double sum = elasticEnergy<2>(c.problem, c.controls, c.state);
    for (std::size_t i = 0; i < mass.size(); ++i) sum += 0.5 * mass[i] * c.state.nodes.v[i].squaredNorm();
    return sum;
}

}  // namespace pfem::test
