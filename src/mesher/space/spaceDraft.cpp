#include "mesher/space/spaceDraft.hpp"

#include <algorithm>
#include <numeric>

#include "conditions/wallFreedom.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/simplex.hpp"
#include "mesh/wallFaces.hpp"
#include "mesher/space/hilbertOrder3.hpp"
#include "walls/wallPoints.hpp"

namespace pfem {

namespace {

int materialIndex(Mesh<3>& mesh, const std::string& name) {
    const auto it = std::find(mesh.materials.begin(), mesh.materials.end(), name);
    if (it != mesh.materials.end()) return static_cast<int>(it - mesh.materials.begin());
    mesh.materials.push_back(name);
    return static_cast<int>(mesh.materials.size()) - 1;
}

/// The least node first, in the same orientation.
Simplex<3> leastFirst(Simplex<3> s) {
    const auto least = std::min_element(s.begin(), s.end()) - s.begin();
    if (least == 0) return s;
    std::swap(s[0], s[least]);
    // an even permutation: exchange two of the others
    std::swap(s[1], s[least == 1 ? 2 : least == 2 ? 3 : 2]);
    return s;
}

State<3> stateOf(const Tetrahedra& cells, const std::vector<double>& h, std::vector<int>& rank) {
    const auto order = hilbertOrder3(cells.x);
    rank.resize(order.size());
    State<3> state;
    const int n = static_cast<int>(order.size());
    state.nodes.resize(n);
    for (int i = 0; i < n; ++i) {
        rank[order[i]] = i;
        state.nodes.id[i] = i;
        state.nodes.x[i] = state.nodes.X[i] = cells.x[order[i]];
        state.nodes.h[i] = h[order[i]];
    }
    state.nextId = n;
    return state;
}

void addCells(const SpaceDescription& description, int b, const Tetrahedra& cells, const std::vector<int>& rank,
              SpaceMeshResult& result) {
    const SpaceBody& body = description.bodies[b];
    State<3>& state = result.state;
    Cells<3>& to = body.type == BodyType::fluid ? state.mesh.fluid : state.mesh.solid;
    const int first = to.size(), material = materialIndex(state.mesh, body.material);
    for (std::size_t c = 0; c < cells.cells.size(); ++c) {
        if (cells.label[c] != b + 1) continue;
        Simplex<3> s = cells.cells[c];
        for (int& i : s) i = rank[i];
        to.nodes.push_back(leastFirst(s));
        to.material.push_back(material);
    }
    std::sort(to.nodes.begin() + first, to.nodes.end());
    for (int c = first; c < to.size(); ++c)
        for (const int i : to.nodes[c]) state.nodes.v[i] = body.velocityAt(state.nodes.x[i]);
    result.bodies[b] = {first, to.size(), description.sizeOf(body), body.type == BodyType::fluid};
}

void addPatches(const SpaceDescription& description, int b, SpaceMeshResult& result) {
    const SpaceBody& body = description.bodies[b];
    State<3>& state = result.state;
    const Cells<3>& cells = body.type == BodyType::fluid ? state.mesh.fluid : state.mesh.solid;
    if (body.patches.empty()) return;
    const std::vector<Simplex<3>> own(cells.nodes.begin() + result.bodies[b].first,
                                      cells.nodes.begin() + result.bodies[b].last);
    std::vector<Face<3>> boundary;
    for (const auto& face : boundaryFaces<3>(own, nodeToCells<3>(own, state.nodes.size())))
        boundary.push_back(face.nodes);
    for (const auto& [name, selection] : body.patches) {
        auto patch = std::find_if(state.mesh.patches.begin(), state.mesh.patches.end(),
                                  [&, &wanted = name](const Patch<3>& p) { return p.name == wanted; });
        if (patch == state.mesh.patches.end()) patch = state.mesh.patches.insert(patch, {name, {}});
        const auto faces = selectedFaces(description, selection, state.nodes.x, boundary);
        patch->faces.insert(patch->faces.end(), faces.begin(), faces.end());
    }
}

/// Fluid nodes on walls know them, and have no velocity through any that is no opening.
void standOnWalls(const SpaceDescription& description, State<3>& state) {
    std::vector<bool> isWall, isOpening;
    for (const auto& patch : state.mesh.patches) {
        const auto wall = std::find_if(description.walls.begin(), description.walls.end(),
                                       [&](const SpaceWall& one) { return one.name == patch.name; });
        isWall.push_back(wall != description.walls.end());
        isOpening.push_back(isWall.back() && wall->opening);
    }
    if (std::find(isWall.begin(), isWall.end(), true) == isWall.end()) return;
    separateFromWalls<3>(isWall, state);
    const auto faces = wallFaces<3>(state.mesh.patches, isWall, state.nodes.x);
    for (int i = 0; i < state.nodes.size(); ++i) {
        Supports<3> closed = state.nodes.wall[i];
        for (int& wall : closed)
            if (wall >= 0 && isOpening[faces[wall].patch]) wall = -1;
        state.nodes.v[i] = freedomOn<3>(faces, state.nodes.x, closed).project(state.nodes.v[i]);
    }
}

}  // namespace

SpaceMeshResult finishSpaceMesh(const SpaceDescription& description, const Tetrahedra& cells,
                                const std::vector<double>& h) {
    SpaceMeshResult result;
    std::vector<int> rank;
    result.state = stateOf(cells, h, rank);
    const int n = static_cast<int>(description.bodies.size());
    result.bodies.resize(n);
    for (const auto type : {BodyType::fluid, BodyType::solid})  // solids last: theirs is the interface's velocity
        for (int b = 0; b < n; ++b)
            if (description.bodies[b].type == type) addCells(description, b, cells, rank, result);
    addWalls(description, result.state, result.warnings);
    for (int b = 0; b < n; ++b) addPatches(description, b, result);
    standOnWalls(description, result.state);
    return result;
}

}  // namespace pfem
