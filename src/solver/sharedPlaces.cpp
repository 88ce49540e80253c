#include "solver/sharedPlaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "solver/failedStep.hpp"

namespace pfem {

namespace {

enum class Role { wall, opening, clamp, plane, skin, solid, none };

/// What holds a node, or meets it.
struct Holder {
    Role role;
    std::string name;  // with quotation marks
    std::string type;  // of a patch

    bool operator<(const Holder& other) const { return std::tie(role, name) < std::tie(other.role, other.name); }
    std::string title() const { return type.empty() ? "solid " + name : name + " (" + type + ")"; }
};

/// What is done at the nodes of a solid where two meet; {0} and {1}: their names.
struct Rule {
    Role first, second;
    const char* done;
    const char* byContact = nullptr;  // what is done with a file constant/contact, if that is something else
};

constexpr Rule rules[] = {
    {Role::wall, Role::clamp, "{1} holds the solid's nodes; those of the wall are its own"},
    {Role::wall, Role::plane, "the solid's nodes slide along {1}, not along the wall"},
    {Role::wall, Role::skin, "the fluid's nodes slide along both"},
    {Role::wall, Role::solid,
     "nothing holds the solid at the wall, and it can go through: write a file constant/contact, or name its edge "
     "there "
     "in 'patches' (system/meshDict) and make it clamped or symmetry",
     "they meet by contact (constant/contact); the wall goes on under the solid"},
    {Role::opening, Role::clamp, "the fluid sticks to the solid: nothing passes at its nodes"},
    {Role::opening, Role::plane, "the fluid sticks to the solid: nothing passes at its nodes"},
    {Role::opening, Role::skin, "the fluid's nodes slide along the solid, and pass"},
    {Role::opening, Role::solid,
     "the fluid sticks to the solid, and what moves away leaves a gap beside the opening: clamp the edge there"},
    {Role::clamp, Role::plane, "{0} holds the nodes and {1} does not: a motion of {0} should be along {1}"},
    {Role::clamp, Role::skin, "{0} holds the solid's nodes; those of the fluid slide over them"},
    {Role::plane, Role::skin, "the solid's nodes slide along {0}; those of the fluid slide over the solid"},
};

Role roleOf(const PatchType& type) {
    if (type.kind == PatchKind::wall) return Role::wall;
    if (type.kind == PatchKind::opening) return Role::opening;
    if (type.kind == PatchKind::skin) return Role::skin;
    if (type.own == Constraint::fixed) return Role::clamp;
    return type.own == Constraint::slide ? Role::plane : Role::none;
}

/// What holds or meets each node of solids; empty for others, and where there is nothing but the solid.
template <int Dim>
std::vector<std::set<Holder>> holdersOf(const BoundaryConditions<Dim>& conditions, const State<Dim>& state) {
    const Mesh<Dim>& mesh = state.mesh;
    const Nodes<Dim>& nodes = state.nodes;
    const auto topology = makeTopology<Dim>(mesh, conditions.kind, nodes.x, nodes.wall);
    std::vector<std::set<Holder>> holders(nodes.id.size());
    const auto add = [&](int i, int patch) {
        const PatchType& type = *conditions.type[patch];
        if (topology.onSolid[i] && roleOf(type) != Role::none)
            holders[i].insert({roleOf(type), "'" + mesh.patches[patch].name + "'", type.name});
    };
    for (std::size_t k = 0; k < mesh.patches.size(); ++k)
        for (const auto& face : mesh.patches[k].faces)
            for (const int i : face) add(i, static_cast<int>(k));
    for (int i = 0; i < nodes.size(); ++i)
        for (const int wall : topology.supports[i])
            if (wall >= 0) add(i, topology.walls[wall].patch);
    for (int e = 0; e < mesh.solid.size(); ++e)
        for (const int i : mesh.solid.nodes[e])
            if (std::none_of(holders[i].begin(), holders[i].end(),
                             [](const Holder& h) { return h.role == Role::clamp || h.role == Role::plane; }))
                holders[i].insert({Role::solid, "'" + mesh.materials[mesh.solid.material[e]] + "'", ""});
    return holders;
}

const Rule* ruleOf(const Holder& a, const Holder& b) {
    const auto* rule = std::find_if(std::begin(rules), std::end(rules),
                                    [&](const Rule& r) { return r.first == a.role && r.second == b.role; });
    return rule == std::end(rules) ? nullptr : rule;
}

}  // namespace

template <int Dim>
std::vector<SharedPlace<Dim>> sharedPlaces(const BoundaryConditions<Dim>& conditions, bool contact,
                                           const State<Dim>& state) {
    const auto holders = holdersOf<Dim>(conditions, state);
    std::vector<SharedPlace<Dim>> places;
    for (std::size_t i = 0; i < holders.size(); ++i)
        for (auto a = holders[i].begin(); a != holders[i].end(); ++a)
            for (auto b = std::next(a); b != holders[i].end(); ++b) {
                const Rule* rule = ruleOf(*a, *b);
                if (!rule) continue;
                const auto known = std::find_if(places.begin(), places.end(), [&](const auto& place) {
                    return place.first == a->title() && place.second == b->title();
                });
                if (known != places.end()) {
                    ++known->count;
                    continue;
                }
                const char* done = contact && rule->byContact ? rule->byContact : rule->done;
                places.push_back(
                    {a->title(), b->title(), state.nodes.x[i], 1, fmt::format(fmt::runtime(done), a->name, b->name)});
            }
    return places;
}

template <int Dim>
std::string sharedPlacesText(const BoundaryConditions<Dim>& conditions, bool contact, const State<Dim>& state) {
    std::string text;
    for (const auto& place : sharedPlaces<Dim>(conditions, contact, state))
        text += fmt::format("  {} and {} at {}{}: {}\n", place.first, place.second, placeText<Dim>(place.at),
                            place.count > 1 ? fmt::format(" and {} more", place.count - 1) : "", place.done);
    return text.empty() ? text : "Where two meet\n" + text;
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template std::vector<SharedPlace<D>> sharedPlaces<D>(const BoundaryConditions<D>&, bool, const State<D>&); \
    template std::string sharedPlacesText<D>(const BoundaryConditions<D>&, bool, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
