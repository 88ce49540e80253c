#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <tuple>

#include "io/sizesFile.hpp"
#include "io/stateFiles.hpp"
#include "io/stateGrid.hpp"
#include "io/statePart.hpp"
#include "state/images.hpp"

namespace pfem {

using namespace stateGrid;

namespace {

/// The first array whose value at node j of b has other bits than at node i of a; nullptr when all agree.
template <int Dim>
const char* otherBits(const Nodes<Dim>& a, std::size_t i, const Nodes<Dim>& b, std::size_t j) {
    auto same = [](const auto& s, const auto& t) {
        return std::memcmp(s.data(), t.data(), sizeof(double) * static_cast<std::size_t>(s.size())) == 0;
    };
    const char* other = nullptr;
    Nodes<Dim>::fields([&](const char* name, auto field, const auto&, auto) {
        using Value = typename std::decay_t<decltype(a.*field)>::value_type;
        const Value &s = (a.*field)[i], &t = (b.*field)[j];
        if (other != nullptr) return;
        if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, Supports<Dim>>) {
            if (std::memcmp(&s, &t, sizeof s) != 0) other = name;
        } else if constexpr (!std::is_same_v<Value, Stress<Dim>>) {  // solid.vtu alone has the stress
            if (!same(s, t)) other = name;
        }
    });
    return other;
}

/// All parts' nodes by ascending id; the first part that has a node gives its values (solid first: it has
/// stress and history). Nodes in several files must agree.
template <int Dim>
Nodes<Dim> mergeNodes(const std::vector<const Part<Dim>*>& parts) {
    struct Source {
        Id id;
        std::size_t part, node;
    };
    std::vector<Source> sources;
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (std::size_t i = 0; i < parts[k]->nodes.id.size(); ++i) sources.push_back({parts[k]->nodes.id[i], k, i});
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return std::tie(a.id, a.part) < std::tie(b.id, b.part); });
    Nodes<Dim> nodes;
    nodes.history.names = parts[0]->nodes.history.names;
    for (const Source& s : sources) {
        const Nodes<Dim>& from = parts[s.part]->nodes;
        if (nodes.id.empty() || nodes.id.back() != s.id)
            nodes.append(from, static_cast<int>(s.node));
        else if (const char* array = otherBits(nodes, nodes.id.size() - 1, from, s.node))
            parts[s.part]->fail(
                fmt::format("array '{}': node {} has another value than in another file of the folder", array, s.id));
    }
    return nodes;
}

template <int Dim>
int indexOf(const Nodes<Dim>& nodes, Id id) {
    return static_cast<int>(std::lower_bound(nodes.id.begin(), nodes.id.end(), id) - nodes.id.begin());
}

template <std::size_t N, int Dim>
std::array<int, N> toIndices(const std::vector<Id>& ids, const Nodes<Dim>& nodes) {
    std::array<int, N> indices{};
    for (std::size_t i = 0; i < N; ++i) indices[i] = indexOf(nodes, ids[i]);
    return indices;
}

template <int Dim>
Cells<Dim> simplicesOf(const Part<Dim>& part, const Nodes<Dim>& nodes, bool withParticles) {
    Cells<Dim> cells;
    for (std::size_t e = 0; e < part.cells.size(); ++e) {
        if (withParticles && part.types[e] == VTK_VERTEX) continue;
        if (part.types[e] != simplexType<Dim> || part.cells[e].size() != Dim + 1)
            part.fail(fmt::format("array 'types': cell {} has the unexpected type {}", e, part.types[e]));
        if (part.values[e] < 0 || part.values[e] >= static_cast<Id>(part.materials.size()))
            part.fail(fmt::format("array 'material': cell {} has material {} of {}", e, part.values[e],
                                  part.materials.size()));
        cells.nodes.push_back(toIndices<Dim + 1>(part.cells[e], nodes));
        cells.material.push_back(static_cast<int>(part.values[e]));
    }
    return cells;
}

template <int Dim>
std::vector<Patch<Dim>> patchesOf(const Part<Dim>& part, const Nodes<Dim>& nodes) {
    std::vector<Patch<Dim>> patches;
    for (const auto& name : part.patchNames) patches.push_back({name, {}});
    for (std::size_t f = 0; f < part.cells.size(); ++f) {
        if (part.types[f] != faceType<Dim> || part.cells[f].size() != Dim)
            part.fail(fmt::format("array 'types': face {} has the unexpected type {}", f, part.types[f]));
        if (part.values[f] < 0 || part.values[f] >= static_cast<Id>(patches.size()))
            part.fail(
                fmt::format("array 'patch': face {} belongs to patch {} of {}", f, part.values[f], patches.size()));
        patches[static_cast<std::size_t>(part.values[f])].faces.push_back(toIndices<Dim>(part.cells[f], nodes));
    }
    return patches;
}

}  // namespace

template <int Dim>
State<Dim> readState(const std::filesystem::path& folder) {
    const UniformTime uniform = readUniformTime(folder);
    const auto fluid = readPart<Dim>(folder, fluidFile, "material", uniform);
    const auto solid = readPart<Dim>(folder, solidFile, "material", uniform);
    const auto boundary = readPart<Dim>(folder, boundaryFile, "patch", uniform);
    if (!solid.hasStress) solid.fail("array 'sigma' is missing");
    if (solid.materials != fluid.materials) solid.fail("array 'materials' is not that of " + fluidFile);

    State<Dim> state;
    state.time = uniform.time;
    state.nextId = uniform.nextId;
    state.approach = uniform.approach;
    state.ledger.takeFrom(uniform.ledger);
    state.energy.takeFrom(uniform.energy);
    state.memory = uniform.memory;
    if (const auto sizes = uniform.checksums.find("sizes"); sizes != uniform.checksums.end())
        state.sizes = readSizes<Dim>(folder, sizes->second);
    state.nodes = mergeNodes<Dim>({&solid, &fluid, &boundary});
    if (!namesAreValid<Dim>(state))
        fluid.fail(fmt::format("array 'id': node {} is not below nextId {} in uniform/time", state.nodes.id.back(),
                               state.nextId));
    state.mesh.fluid = simplicesOf(fluid, state.nodes, true);
    state.mesh.solid = simplicesOf(solid, state.nodes, false);
    state.mesh.solid.sigma = solid.cellStress;
    state.mesh.solid.history = solid.cellHistory;
    state.mesh.patches = patchesOf(boundary, state.nodes);
    state.mesh.materials = fluid.materials;
    int faces = 0;
    for (const auto& patch : state.mesh.patches) faces += static_cast<int>(patch.faces.size());
    for (int i = 0; i < state.nodes.size(); ++i)
        for (const int wall : state.nodes.wall[i])
            if (wall >= faces)
                fluid.fail(
                    fmt::format("array 'wall': node {} slides on wall face {} of {}", state.nodes.id[i], wall, faces));
    return state;
}

template State<2> readState<2>(const std::filesystem::path&);
template State<3> readState<3>(const std::filesystem::path&);

}  // namespace pfem
