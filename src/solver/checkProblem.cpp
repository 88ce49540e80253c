#include "solver/checkProblem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dictionary/flatEntries.hpp"
#include "integration/stressPoints.hpp"
#include "io/uniformTime.hpp"
#include "material/rigid.hpp"
#include "mesh/simplex.hpp"
#include "solver/checkMotions.hpp"
#include "solver/checkWaves.hpp"

namespace pfem {

namespace {

/// Is the face an edge of one of the cells?
template <int Dim>
bool isFaceOf(const std::vector<Simplex<Dim>>& cells, const NodeToCells& around, const Face<Dim>& face) {
    for (int s = around.start[face[0]]; s < around.start[face[0] + 1]; ++s) {
        const auto& cell = cells[around.cell[s]];
        if (std::all_of(face.begin(), face.end(),
                        [&](int node) { return std::find(cell.begin(), cell.end(), node) != cell.end(); }))
            return true;
    }
    return false;
}

/// What the mesh knows of a patch.
struct PatchRole {
    bool onSolid = false;   // it has a face of a solid
    bool offSolid = false;  // it has a face of no solid
    bool wall = false;      // fluid slides along it, or, before the first step, it has a face of no body
};

template <int Dim>
std::vector<PatchRole> patchRoles(const State<Dim>& state) {
    const auto& mesh = state.mesh;
    const auto solid = nodeToCells<Dim>(mesh.solid.nodes, state.nodes.size());
    const auto fluid = nodeToCells<Dim>(mesh.fluid.nodes, state.nodes.size());
    std::vector<PatchRole> roles(mesh.patches.size());
    std::vector<std::size_t> patchOfFace;
    for (std::size_t k = 0; k < roles.size(); ++k)
        for (const auto& face : mesh.patches[k].faces) {
            const bool onSolid = isFaceOf<Dim>(mesh.solid.nodes, solid, face);
            (onSolid ? roles[k].onSolid : roles[k].offSolid) = true;
            if (state.time.index == 0 && !onSolid && !isFaceOf<Dim>(mesh.fluid.nodes, fluid, face))
                roles[k].wall = true;
            patchOfFace.push_back(k);
        }
    for (const auto& supports : state.nodes.wall)
        for (const int w : supports)
            if (w >= 0) roles[patchOfFace[w]].wall = true;
    return roles;
}

/// An inlet that pushes water at rest at once, now or when it starts, with an elastic solid in it; "" without.
template <int Dim>
std::string suddenInlet(const Problem<Dim>& problem, const State<Dim>& state) {
    const auto& mesh = state.mesh;
    std::vector<char> ofFluid(state.nodes.x.size(), 0);
    for (const auto& cell : mesh.fluid.nodes)
        for (const int i : cell) {
            if (state.nodes.v[i].norm() > 0) return "";
            ofFluid[i] = 1;
        }
    bool wetSolid = false;
    for (int e = 0; e < mesh.solid.size() && !wetSolid; ++e)
        wetSolid =
            !rigidOf(problem.solid(mesh.solid.material[e]).law.get()) &&
            std::any_of(mesh.solid.nodes[e].begin(), mesh.solid.nodes[e].end(), [&](int i) { return ofFluid[i]; });
    int face = 0;  // the first of the patch, as Nodes::wall counts
    for (std::size_t k = 0; wetSolid && k < mesh.patches.size(); ++k) {
        const int first = face, last = face += static_cast<int>(mesh.patches[k].faces.size());
        const auto& inlet = problem.conditions.inlet[k];
        if (!inlet || inlet->at(std::max(state.time.value, inlet->start)) == 0) continue;
        for (int i = 0; i < state.nodes.size(); ++i)
            for (const int wall : state.nodes.wall[i])
                if (ofFluid[i] && wall >= first && wall < last) return mesh.patches[k].name;
    }
    return "";
}

/// Nothing is denser in g/cm3, or in units with smaller numbers; in kg/m3 all liquids are.
constexpr double densest = 25;

}  // namespace

template <int Dim>
void checkOneFluid(const Dictionary& materials, const Mesh<Dim>& mesh) {
    for (int m : mesh.fluid.material) {
        if (m == mesh.fluid.material[0]) continue;
        const auto &first = mesh.materials[mesh.fluid.material[0]], &second = mesh.materials[m];
        throw UserError("There are fluids of different materials, '" + first + "' and '" + second +
                            "': a case can have several bodies of fluid, but of one material only",
                        materials.where(second));
    }
}

template <int Dim>
void checkConditions(const Dictionary& dict, const BoundaryConditions<Dim>& conditions, const State<Dim>& state) {
    const auto roles = patchRoles<Dim>(state);
    for (std::size_t k = 0; k < roles.size(); ++k) {
        const std::string& name = state.mesh.patches[k].name;
        const Dictionary& entry = dict.subDict(name);
        const PatchType& type = *conditions.type[k];
        const auto list = [&](bool walls) {
            return typeList([&](const PatchType& t) { return isWall(t.kind) == walls; }, " or ");
        };
        if (isWall(type.kind) && roles[k].onSolid)
            entry.fatal("type", "'" + name + "' is the edge of a solid: it can be " + list(false));
        if (!holdsFluid(type.kind) && roles[k].wall)
            entry.fatal("type", "'" + name + "' is a rigid wall: it can be " + list(true));
        if (type.onlyOfSolids && roles[k].offSolid)
            entry.fatal("type", "'" + name + "' is not the edge of a solid: only solids can be clamped or loaded");
        // faces of the fluid are new in every step: in space they are not those of the patch for long
        if (Dim == 3 && type.kind == PatchKind::symmetry && roles[k].offSolid)
            entry.fatal("type", "'" + name +
                                    "' is not on a solid alone: in space a plane of symmetry of the fluid is a wall "
                                    "(walls in system/meshDict) of type slip");
    }
    checkMotions<Dim>(dict, conditions, state);
}

template <int Dim>
void checkState(const std::filesystem::path& folder, const State<Dim>& state) {
    const auto fail = [&](const char* file, const std::string& reason) {
        throw UserError(fmt::format("cannot go on from \"{}\": {}", folder.string(), reason),
                        {(folder / file).string(), 0});
    };
    if (const std::string name = readUniformTime(folder).name; !name.empty() && name != folder.filename().string())
        fail("uniform/time", fmt::format("entry 'name' says that this is the time {}; was the folder renamed?", name));
    const auto& nodes = state.nodes;
    for (int i = 0; i < nodes.size(); ++i)
        if (!(nodes.h[i] > 0))
            fail("fluid.vtu", fmt::format("array 'h': node {} has the mesh size {}", nodes.id[i], nodes.h[i]));
    for (const auto& cell : state.mesh.solid.nodes)
        if (!(simplexMeasure<Dim>(nodes.x, cell) > 0))
            fail("solid.vtu", fmt::format("array 'Points': the element with the nodes {} {} {} is inverted",
                                          nodes.id[cell[0]], nodes.id[cell[1]], nodes.id[cell[2]]));
}

template <int Dim>
std::vector<std::string> doubts(const Dictionary& materials, const Dictionary& gravity, const Dictionary& conditions,
                                const Problem<Dim>& problem, const State<Dim>& state) {
    std::vector<std::string> found;
    const auto doubt = [&](const Dictionary& dict, const std::string& key, const std::string& text) {
        const Location at = dict.where(key);
        found.push_back(fmt::format("entry '{}' in {}:{}: {}", key, at.file, at.line, text));
    };
    const double g = problem.gravity.norm();
    bool driven = g > 0;
    Vec<Dim> low = Vec<Dim>::Zero(), high = low;
    for (int i = 0; i < state.nodes.size(); ++i) {
        driven = driven || state.nodes.v[i].norm() > 0 || state.nodes.sigma[i].norm() > 0;
        low = i == 0 ? state.nodes.x[i] : Vec<Dim>(low.cwiseMin(state.nodes.x[i]));
        high = i == 0 ? state.nodes.x[i] : Vec<Dim>(high.cwiseMax(state.nodes.x[i]));
    }
    if (const auto inlet = suddenInlet<Dim>(problem, state); !inlet.empty())
        doubt(
            conditions.subDict(inlet), "type",
            "water at rest has to move with this velocity at once, and elastic solids in it with the same impulse: "
            "they "
            "may be torn. Let the inlet's rate begin with 0 (type table), or give the body of water its 'velocity' in "
            "system/meshDict");
    driven = driven || problem.conditions.anyInlet() || problem.flow || problem.frameOverTime;
    for (const auto& traction : problem.conditions.traction) driven = driven || traction.norm() > 0;
    for (const auto& [entry, value] : flatEntries(conditions))
        driven = driven || entry.find(".motion") != std::string::npos;
    if (!driven)
        doubt(gravity, "value", "nothing will move: gravity and all velocities are zero, and there is no load");
    for (const auto& text : doubtsAboutWaves<Dim>(conditions, problem, state)) found.push_back(text);
    double heaviest = 0;
    for (const auto& material : problem.materials)
        heaviest = std::max(heaviest, material.kind == MaterialKind::fluid ? material.fluid.rho : material.solid.rho);
    const bool inMetres = heaviest > densest;
    if (g > 1000 && inMetres)
        doubt(gravity, "value", fmt::format("gravity of {:g} m/s2 is a hundred times that of the earth", g));
    for (const auto& material : problem.materials) {
        const double depth = (high - low).norm();
        if (material.kind == MaterialKind::fluid && !inMetres && !materials.subDict(material.name).found("kappa"))
            doubt(materials.subDict(material.name), "rho",
                  fmt::format("not in kg/m3, it seems, and without an entry 'kappa' the bulk modulus is {:g}, that of "
                              "water in Pa: "
                              "give it in the units of the case",
                              material.fluid.kappa));
        if (material.kind == MaterialKind::fluid && material.fluid.rho * g * depth > 0.1 * material.fluid.kappa)
            doubt(materials.subDict(material.name), "kappa",
                  fmt::format("under its own weight ({:.3g} m deep) this fluid loses more than a tenth of its volume",
                              depth));
        if (material.kind == MaterialKind::solid && !rigidOf(material.solid.law.get()) &&
            material.solid.rho * g * depth > 10 * material.solid.elastic.E)
            doubt(materials.subDict(material.name), materials.subDict(material.name).found("E") ? "E" : "type",
                  "this solid is crushed by its own weight");
    }
    return found;
}

template <int Dim>
void checkLaws(const Problem<Dim>& problem, const Mesh<Dim>& mesh, Integration ofSolids) {
    if (!mixesCells(ofSolids)) return;
    std::map<int, int> cellOf;
    const auto isRigid = [&](int e) { return rigidOf(problem.solid(mesh.solid.material[e]).law.get()) != nullptr; };
    const auto kindOf = [&](int e) { return problem.solid(mesh.solid.material[e]).law->kinematics(); };
    for (int e = 0; e < mesh.solid.size(); ++e)
        for (const int node : mesh.solid.nodes[e]) {
            const int other = cellOf.emplace(node, e).first->second;
            if (isRigid(other) != isRigid(e))
                throw UserError(fmt::format(
                    "The solids of the materials '{}' and '{}' have common nodes, but only one is rigid: use "
                    "'solid {{ integration elemental; }}' in system/pfemSolution",
                    problem.materials[mesh.solid.material[other]].name,
                    problem.materials[mesh.solid.material[e]].name));
            if (kindOf(other) == kindOf(e)) continue;
            throw UserError(fmt::format(
                "The solids of the materials '{}' and '{}' have common nodes, but one law takes its stress from the "
                "deformation since the start and the other from the strain of each step: a node cannot have the mean "
                "of "
                "both. Use 'solid {{ integration elemental; }}' in system/pfemSolution, or laws of one kind",
                problem.materials[mesh.solid.material[other]].name, problem.materials[mesh.solid.material[e]].name));
        }
}

#define PFEM_INSTANTIATE(D)                                                                              \
    template void checkLaws<D>(const Problem<D>&, const Mesh<D>&, Integration);                          \
    template std::vector<std::string> doubts<D>(const Dictionary&, const Dictionary&, const Dictionary&, \
                                                const Problem<D>&, const State<D>&);                     \
    template void checkState<D>(const std::filesystem::path&, const State<D>&);                          \
    template void checkOneFluid<D>(const Dictionary&, const Mesh<D>&);                                   \
    template void checkConditions<D>(const Dictionary&, const BoundaryConditions<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
