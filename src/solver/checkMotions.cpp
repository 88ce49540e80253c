#include "solver/checkMotions.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <sstream>

#include "conditions/givingWay.hpp"
#include "conditions/rigidBodies.hpp"
#include "dictionary/print.hpp"
#include "solver/failedStep.hpp"

namespace pfem {

namespace {

/// The text of a patch's motion, empty without. One that gives way to waves sees its own water: no other moves so.
std::string motionText(const Dictionary& entry, const std::string& patch) {
    if (!entry.found("motion")) return "";
    const Dictionary& motion = entry.subDict("motion");
    std::ostringstream text;
    print(text, motion);
    return text.str() + (motion.found("absorb") ? patch : "");
}

/// Two patches that do not move alike, at a node of each.
struct Quarrel {
    std::size_t patch, other;
    int node, nodeOfOther;
};

/// Of patches that hold their nodes, the first that does not move as another one of the same owner; `ownerOf`: of a
/// node, -1: none.
template <int Dim, class OwnerOf>
std::optional<Quarrel> quarrelOf(const Dictionary& dict, const BoundaryConditions<Dim>& conditions,
                                 const Mesh<Dim>& mesh, const OwnerOf& ownerOf) {
    std::map<int, std::pair<std::size_t, int>> first;  // by owners: patch and node
    std::vector<std::string> motion(mesh.patches.size());
    for (std::size_t k = 0; k < mesh.patches.size(); ++k) {
        if (!conditions.type[k]->mayMove) continue;
        motion[k] = motionText(dict.subDict(mesh.patches[k].name), mesh.patches[k].name);
        for (const auto& face : mesh.patches[k].faces)
            for (const int node : face) {
                const int owner = ownerOf(node);
                if (owner < 0) continue;
                const auto [other, at] = first.emplace(owner, std::pair(k, node)).first->second;
                if (motion[k] != motion[other]) return Quarrel{k, other, node, at};
            }
    }
    return std::nullopt;
}

/// Refuse it at the motion of one of the two.
template <int Dim>
[[noreturn]] void refuse(const Dictionary& dict, const BoundaryConditions<Dim>& conditions, const State<Dim>& state,
                         const Quarrel& quarrel, const std::string& reason) {
    const std::size_t moving = conditions.motion[quarrel.patch] ? quarrel.patch : quarrel.other;
    dict.subDict(state.mesh.patches[moving].name).fatal("motion", reason);
}

}  // namespace

template <int Dim>
void checkMotions(const Dictionary& dict, const BoundaryConditions<Dim>& conditions, const State<Dim>& state) {
    if (!conditions.anyMotion()) return;
    for (std::size_t k = 0; k < state.mesh.patches.size(); ++k) {
        if (!conditions.motion[k] || !conditions.motion[k]->absorption()) continue;
        const auto& patch = state.mesh.patches[k];
        const Vec<Dim> up = conditions.motion[k]->absorption()->up.template head<Dim>();
        if (levelNormal<Dim>(patch.faces, state.nodes.x, up).norm() > 0) continue;
        dict.subDict(patch.name)
            .subDict("motion")
            .fatal("absorb", "'" + patch.name +
                                 "' is no upright wall with water on one side: it cannot give way to "
                                 "waves. Make the end of the flume a wall of its own");
    }
    const auto found = quarrelOf<Dim>(dict, conditions, state.mesh, [](int node) { return node; });
    if (!found) return;
    const bool walls = isWall(conditions.kind[found->patch]);
    refuse<Dim>(
        dict, conditions, state, *found,
        fmt::format("'{}' and '{}' have a common corner at {} but do not move alike. {}; then run pfemMesh again",
                    state.mesh.patches[found->patch].name, state.mesh.patches[found->other].name,
                    placeText<Dim>(state.nodes.x[found->node]),
                    walls ? "A wall that leaves other walls needs the entry 'moving true;' in system/meshDict"
                          : "Give both edges of the solid the same motion, or end one of them before the "
                            "corner: with a vertex more in system/meshDict"));
}

template <int Dim>
void checkRigidMotions(const Dictionary& dict, const Problem<Dim>& problem, const State<Dim>& state) {
    if (!problem.conditions.anyMotion() || !hasRigidBodies<Dim>(problem)) return;
    std::vector<int> bodyOf(state.nodes.id.size(), -1);
    int count = 0;
    for (const auto& body : rigidBodies<Dim>(problem, state.mesh, state.nodes)) {
        for (const int i : body.nodes) bodyOf[i] = count;
        ++count;
    }
    const auto found = quarrelOf<Dim>(dict, problem.conditions, state.mesh, [&](int node) { return bodyOf[node]; });
    if (!found) return;
    refuse<Dim>(dict, problem.conditions, state, *found,
                fmt::format("'{}' at {} and '{}' at {} are edges of one rigid body but do not move alike, and one of "
                            "them moves it as a whole. Give both the same motion (without an entry 'motion' a clamped "
                            "edge stands still), or take one of them out of 'patches' in system/meshDict",
                            state.mesh.patches[found->patch].name, placeText<Dim>(state.nodes.x[found->node]),
                            state.mesh.patches[found->other].name, placeText<Dim>(state.nodes.x[found->nodeOfOther])));
}

#define PFEM_INSTANTIATE(D)                                                                          \
    template void checkMotions<D>(const Dictionary&, const BoundaryConditions<D>&, const State<D>&); \
    template void checkRigidMotions<D>(const Dictionary&, const Problem<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
