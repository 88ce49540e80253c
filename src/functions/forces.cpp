#include "functions/forces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/vectors.hpp"
#include "functions/balance.hpp"
#include "functions/faceForce.hpp"
#include "momentum/meniscus.hpp"
#include "solver/setup.hpp"

namespace pfem {

namespace {

bool contains(const std::vector<int>& all, int value) { return std::find(all.begin(), all.end(), value) != all.end(); }

std::string columns(const Table& table, double time, const std::vector<Eigen::Vector3d>& vectors) {
    std::string line = table.time(time);
    for (const auto& v : vectors)
        line += fmt::format("\t({} {} {})", table.number(v[0]), table.number(v[1]), table.number(v[2]));
    return line;
}

/// What the surface's edge hangs with on the solids of these materials.
template <int Dim>
void addMeniscusOn(const Problem<Dim>& problem, const State<Dim>& state, const Topology<Dim>& topology,
                   const std::vector<int>& materials, ForceAndMoment& sum) {
    const Nodes<Dim>& nodes = state.nodes;
    Points<Dim> force(nodes.x.size(), Vec<Dim>::Zero());
    addMeniscus<Dim>(problem, state.mesh.fluid, topology, nodes, force);
    for (int i = 0; i < nodes.size(); ++i)
        if (topology.interface(i) &&
            contains(materials, state.mesh.solid.material[topology.solid.cell[topology.solid.start[i]]]))
            sum.add(inSpace<Dim>(nodes.x[i]), inSpace<Dim>(force[i]));
}

}  // namespace

template <int Dim>
FluidForce fluidForce(const Problem<Dim>& problemOfRun, const State<Dim>& state, const std::vector<int>& patches,
                      const std::vector<int>& materials) {
    const Problem<Dim> problem = problemAt<Dim>(state.time.value, problemOfRun);
    FluidForce sum;
    const auto topology = makeTopology<Dim>(state.mesh, problem.conditions.kind, state.nodes.x, state.nodes.wall);
    for (const auto& face : wetFaces<Dim>(state, topology)) {
        if (!contains(patches, face.patch) && !contains(materials, face.solid)) continue;
        const auto force = faceForce<Dim>(problem, state, face);
        for (std::size_t i = 0; i < Dim; ++i) {
            const Eigen::Vector3d x = inSpace<Dim>(state.nodes.x[face.nodes[i]]);
            sum.pressure.add(x, inSpace<Dim>(force.pressure[i]));
            sum.viscous.add(x, inSpace<Dim>(force.viscous[i]));
        }
    }
    if (!materials.empty()) addMeniscusOn<Dim>(problem, state, topology, materials, sum.pressure);
    return sum;
}

template <int Dim>
ForceAndMoment reaction(const Problem<Dim>& problem, const Controls& controls, const State<Dim>& state,
                        const std::vector<int>& patches) {
    const auto forces = supportForces<Dim>(problem, controls, state);
    std::vector<int> nodes;
    for (const int k : patches)
        for (const auto& face : state.mesh.patches[k].faces) nodes.insert(nodes.end(), face.begin(), face.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    ForceAndMoment sum;
    for (const int i : nodes) sum.add(inSpace<Dim>(state.nodes.x[i]), inSpace<Dim>(forces[i]));
    return sum;
}

template <int Dim>
Forces<Dim>::Forces(const Dictionary& dict, const FunctionContext<Dim>& context) : dict_(dict), context_(context) {
    readEntries(dict, entries_);
    if (entries_.patches.empty() && entries_.solids.empty())
        dict.fatal("patches", "forces on what? patches (names of walls or clamped patches); or solids (materials);");
}

/// Names to indices. Throws UserError with the valid names.
template <int Dim>
void Forces<Dim>::sortNames(const State<Dim>& state) {
    const auto indexOf = [&](const char* key, const std::string& name, const std::string& what,
                             const std::vector<std::string>& valid) {
        const auto found = std::find(valid.begin(), valid.end(), name);
        if (found == valid.end()) dict_.fatal(key, notValid(name, what, valid));
        return static_cast<int>(found - valid.begin());
    };
    std::vector<std::string> names;
    for (const auto& patch : state.mesh.patches) names.push_back(patch.name);
    for (const auto& name : entries_.patches) {
        const int k = indexOf("patches", name, "patch", names);
        (holdsFluid(problem_->conditions.kind[k]) ? walls_ : supports_).push_back(k);
        if (problem_->conditions.type[k]->loads)
            dict_.fatal("patches", "'" + name + "' is a loaded edge: its force is known, and it bears nothing");
    }
    for (const auto& name : entries_.solids)
        materials_.push_back(indexOf("solids", name, "material", state.mesh.materials));
}

template <int Dim>
void Forces<Dim>::start(const State<Dim>& state) {
    problem_ = readProblem<Dim>(Case(context_.root), state, nullptr);
    controls_ = readControls(Case(context_.root), nullptr);
    sortNames(state);
    const auto begin = [&](const std::string& file, const std::string& title, const std::string& head) {
        Table table(context_.folder / file, context_.precision, context_.resumeAt);
        table.comment(title);
        table.comment(
            fmt::format("CofR                : ({} {} {})", entries_.CofR[0], entries_.CofR[1], entries_.CofR[2]));
        table.line("#");
        table.comment("Time\t" + head);
        return table;
    };
    const std::string parts =
        "(total_x total_y total_z)\t(pressure_x pressure_y pressure_z)\t(viscous_x viscous_y viscous_z)";
    if (!walls_.empty() || !materials_.empty()) {
        force_ = begin("force.dat", "Force", parts);
        moment_ = begin("moment.dat", "Moment", parts);
    }
    if (!supports_.empty())
        reaction_ = begin("reaction.dat", "Force and moment of the supports on what they hold",
                          "(force_x force_y force_z)\t(moment_x moment_y moment_z)");
}

template <int Dim>
void Forces<Dim>::execute(const State<Dim>& state) {
    const double time = state.time.value;
    if (force_) {
        const FluidForce f = fluidForce<Dim>(*problem_, state, walls_, materials_);
        const Eigen::Vector3d pressure = f.pressure.momentAbout(entries_.CofR),
                              viscous = f.viscous.momentAbout(entries_.CofR);
        force_->line(columns(*force_, time, {f.pressure.force + f.viscous.force, f.pressure.force, f.viscous.force}));
        moment_->line(columns(*moment_, time, {pressure + viscous, pressure, viscous}));
    }
    if (reaction_) {
        const auto r = reaction<Dim>(*problem_, controls_, state, supports_);
        reaction_->line(columns(*reaction_, time, {r.force, r.momentAbout(entries_.CofR)}));
    }
}

#define PFEM_INSTANTIATE(D)                                                                                            \
    template FluidForce fluidForce<D>(const Problem<D>&, const State<D>&, const std::vector<int>&,                     \
                                      const std::vector<int>&);                                                        \
    template ForceAndMoment reaction<D>(const Problem<D>&, const Controls&, const State<D>&, const std::vector<int>&); \
    template class Forces<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
