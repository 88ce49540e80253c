#pragma once
// Small cases in three dimensions for tests.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "material/material.hpp"
#include "mesh/simplex.hpp"
#include "solver/simulation.hpp"
#include "walls/wallPoints.hpp"

namespace pfem::test {

struct TestCase3 : Simulation<3> {
    const std::vector<PatchKind>& kinds() const { return problem.conditions.kind; }
    Topology<3> topology() const { return makeTopology<3>(state.mesh, kinds(), state.nodes.x, state.nodes.wall); }
    NodeConstraints<3> constraints(const Topology<3>& topology) const {
        return nodeConstraints<3>(state.mesh, problem.conditions, topology, state.nodes, state.time.value,
                                  state.time.value);
    }
    void tolerance(double value, int maxIterations = 200) {
        controls.convergence.tolU = controls.convergence.tolP = value;
        controls.convergence.maxIterations = maxIterations;
    }
};

/// Tetrahedra of a box from `low` to `high`, six to a cube of about size h, for which `isIn` says yes; their nodes.
inline void addLattice(State<3>& state, Cells<3>& cells, int material, const Vec<3>& low, const Vec<3>& high, double h,
                       const std::function<bool(const Vec<3>&)>& isIn = nullptr) {
    std::array<int, 3> n{};
    for (int d = 0; d < 3; ++d) n[d] = std::max(1, static_cast<int>(std::lround((high[d] - low[d]) / h)));
    std::map<std::array<int, 3>, int> index;
    auto& nodes = state.nodes;
    const auto node = [&](std::array<int, 3> at) {
        const auto [place, isNew] = index.emplace(at, nodes.size());
        if (!isNew) return place->second;
        Vec<3> x;
        for (int d = 0; d < 3; ++d) x[d] = low[d] + (high[d] - low[d]) * at[d] / n[d];
        for (int i = 0; i < nodes.size(); ++i)  // bodies that touch share their nodes
            if ((nodes.x[i] - x).norm() < 1e-9 * h) return place->second = i;
        nodes.resize(nodes.size() + 1);
        nodes.id.back() = state.nextId++;
        nodes.x.back() = nodes.X.back() = x;
        nodes.h.back() = h;
        return place->second;
    };
    constexpr int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int i = 0; i < n[0]; ++i)
        for (int j = 0; j < n[1]; ++j)
            for (int k = 0; k < n[2]; ++k) {
                const Vec<3> middle =
                    low + Vec<3>((i + 0.5) / n[0], (j + 0.5) / n[1], (k + 0.5) / n[2]).cwiseProduct(high - low);
                if (isIn && !isIn(middle)) continue;
                for (const auto& steps : order) {
                    std::array<int, 3> at{i, j, k};
                    Simplex<3> cell{};
                    cell[0] = node(at);
                    for (int s = 0; s < 3; ++s) {
                        ++at[steps[s]];
                        cell[s + 1] = node(at);
                    }
                    if (simplexMeasure<3>(nodes.x, cell) < 0) std::swap(cell[0], cell[1]);
                    cells.nodes.push_back(cell);
                    cells.material.push_back(material);
                }
            }
}

/// A patch of the faces of the solids whose nodes all satisfy `isOn`.
inline Patch<3> solidPatch(const State<3>& state, const std::string& name,
                           const std::function<bool(const Vec<3>&)>& isOn) {
    Patch<3> patch{name, {}};
    const auto& cells = state.mesh.solid.nodes;
    for (const auto& face : boundaryFaces<3>(cells, nodeToCells<3>(cells, state.nodes.size())))
        if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](int i) { return isOn(state.nodes.x[i]); }))
            patch.faces.push_back(face.nodes);
    return patch;
}

/// A wall of two triangles with the area vectors out of the fluid; corners in a circle as seen from the fluid's side.
inline void addQuad(State<3>& state, Patch<3>& patch, const std::array<Vec<3>, 4>& corners, const Vec<3>& inside) {
    auto& nodes = state.nodes;
    std::array<int, 4> at{};
    for (int k = 0; k < 4; ++k) {
        at[k] = -1;
        for (const auto& face : patch.faces)
            for (const int i : face)
                if ((nodes.x[i] - corners[k]).norm() < 1e-9) at[k] = i;
        if (at[k] >= 0) continue;
        at[k] = nodes.size();
        nodes.resize(nodes.size() + 1);
        nodes.id.back() = state.nextId++;
        nodes.x.back() = nodes.X.back() = corners[k];
        nodes.h.back() = 1;
    }
    for (Face<3> face : {Face<3>{at[0], at[1], at[2]}, Face<3>{at[0], at[2], at[3]}}) {
        if (faceArea<3>(nodes.x, face).dot(inside - nodes.x[face[0]]) > 0) std::swap(face[1], face[2]);
        patch.faces.push_back(face);
    }
}

/// A tank from the origin to `size` without a lid.
inline Patch<3> openBox(State<3>& state, const std::string& name, const Vec<3>& size) {
    Patch<3> patch{name, {}};
    const auto at = [&](int k) { return Vec<3>(k & 1 ? size[0] : 0, k & 2 ? size[1] : 0, k & 4 ? size[2] : 0); };
    for (const auto& q : {std::array{0, 1, 3, 2}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
        addQuad(state, patch, {at(q[0]), at(q[1]), at(q[2]), at(q[3])}, 0.5 * size);
    return patch;
}

/// Water from the origin to `column` in an open box of size `tank` (z up).
inline TestCase3 boxOfWater(const Vec<3>& column, const Vec<3>& tank, double h, const std::string& type = "slip",
                            double mu = 1e-3, double jitter = 0) {
    TestCase3 c;
    State<3>& state = c.state;
    state.mesh.materials = {"water"};
    addLattice(state, state.mesh.fluid, 0, Vec<3>::Zero(), column, h);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-jitter * h, jitter * h);
    for (auto& x : state.nodes.x)
        for (int d = 0; d < 3; ++d)
            if (x[d] > 1e-9 && x[d] < column[d] - 1e-9) x[d] += shift(random);
    state.nodes.X = state.nodes.x;
    state.mesh.patches.push_back(openBox(state, "tank", tank));
    c.problem.materials = readMaterials(Dictionary::parse(
        "water { type newtonian; rho 1000; mu " + std::to_string(mu) + "; kappa 2.1e9; }", "materials"));
    c.problem.gravity = {0, 0, -9.81};
    c.problem.conditions = readBoundaryConditions<3>(
        Dictionary::parse("tank { type " + type + "; }", "boundaryConditions"), state.mesh.patches);
    separateFromWalls<3>({true}, state);
    return c;
}

}  // namespace pfem::test
