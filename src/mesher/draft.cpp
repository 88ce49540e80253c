#include "mesher/draft.hpp"

#include <algorithm>

#include "mesher/hilbertOrder.hpp"
#include "mesher/wallLines.hpp"
#include "walls/wallPoints.hpp"

namespace pfem {

int materialIndex(Mesh<2>& mesh, const std::string& name) {
    const auto it = std::find(mesh.materials.begin(), mesh.materials.end(), name);
    if (it != mesh.materials.end()) return static_cast<int>(it - mesh.materials.begin());
    mesh.materials.push_back(name);
    return static_cast<int>(mesh.materials.size()) - 1;
}

Patch<2>& patchNamed(Mesh<2>& mesh, const std::string& name) {
    for (auto& patch : mesh.patches)
        if (patch.name == name) return patch;
    mesh.patches.push_back({name, {}});
    return mesh.patches.back();
}

namespace {

/// Walls do not let the fluid through: its initial velocity there is the part along the wall. Openings do.
void alignWithWalls(Draft& draft, const MeshDescription& description) {
    for (const auto& wall : description.walls) {
        if (wall.opening) continue;
        for (const auto& [a, b] : patchNamed(draft.mesh, wall.name).faces) {
            const Vec<2> along = (draft.x[b] - draft.x[a]).normalized();
            for (const int i : {a, b}) {
                const Vec<2> part = along * along.dot(draft.v[i]);
                draft.v[i] = part;
            }
        }
    }
}

void renumber(Draft& draft) {
    const auto order = hilbertOrder(draft.x);
    std::vector<int> rank(order.size());
    Draft sorted;
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = static_cast<int>(i);
        sorted.x.push_back(draft.x[order[i]]);
        sorted.v.push_back(draft.v[order[i]]);
        sorted.h.push_back(draft.h[order[i]]);
    }
    draft.x.swap(sorted.x);
    draft.v.swap(sorted.v);
    draft.h.swap(sorted.h);
    for (auto* cells : {&draft.mesh.fluid, &draft.mesh.solid}) {
        for (auto& t : cells->nodes) {
            for (int& i : t) i = rank[i];
            std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        }
    }
    for (auto& patch : draft.mesh.patches)
        for (auto& face : patch.faces)
            for (int& i : face) i = rank[i];
}

State<2> toState(Draft&& draft) {
    State<2> state;
    const int n = static_cast<int>(draft.x.size());
    state.nodes.resize(n);
    for (int i = 0; i < n; ++i) state.nodes.id[i] = i;
    state.nodes.x = state.nodes.X = std::move(draft.x);
    state.nodes.v = std::move(draft.v);
    state.nodes.h = std::move(draft.h);
    state.mesh = std::move(draft.mesh);
    state.nextId = n;
    return state;
}

}  // namespace

State<2> finishMesh(Draft draft, const MeshDescription& description, const std::vector<MeshedBody>& bodies) {
    alignWithWalls(draft, description);
    renumber(draft);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        auto& cells = description.bodies[b].type == BodyType::fluid ? draft.mesh.fluid : draft.mesh.solid;
        std::sort(cells.nodes.begin() + bodies[b].first, cells.nodes.begin() + bodies[b].last);
    }
    State<2> state = toState(std::move(draft));
    std::vector<std::string> walls, moving;
    for (const auto& wall : description.walls) {
        walls.push_back(wall.name);
        if (wall.moving) moving.push_back(wall.name);
    }
    separateWalls(walls, moving, state);
    straightenWalls(walls, state);
    std::vector<bool> isWall;
    for (const auto& patch : state.mesh.patches)
        isWall.push_back(std::find(walls.begin(), walls.end(), patch.name) != walls.end());
    separateFromWalls<2>(isWall, state);
    return state;
}

}  // namespace pfem
