#include "functions/energy.hpp"

#include <algorithm>

#include "momentum/residual.hpp"
#include "solver/setup.hpp"

namespace pfem {

template <int Dim>
Energy<Dim>::Energy(const Dictionary&, const FunctionContext<Dim>& context) : context_(context) {
    context_.precision = std::max(8, context_.precision);  // small differences of large numbers
}

template <int Dim>
void Energy<Dim>::start(const State<Dim>& state) {
    problem_ = readProblem<Dim>(Case(context_.root), state, nullptr);
    controls_ = readControls(Case(context_.root), nullptr);
    first_ = storedEnergy<Dim>(*problem_, controls_, state).total();
    firstRemeshing_ = state.energy[EnergyCause::remeshing];
    firstVolume_ = state.energy[EnergyCause::volume];
    flows_ = {};
    const auto found = state.memory.find(context_.name);
    if (found != state.memory.end() && found->second.size() >= 5) {
        const auto& m = found->second;
        first_ = m[0];
        flows_ = {m[1], m[2], m[3], m[4]};
        if (m.size() >= 7) {  // 5 in folders of older versions
            firstRemeshing_ = m[5];
            firstVolume_ = m[6];
        }
    }
    time_ = state.time.value;
    powers_ = energyPowers<Dim>(problemAt<Dim>(time_, *problem_), controls_, state);
    ids_ = state.nodes.id;
    x_ = state.nodes.x;
    loads_ = tractionForce<Dim>(state.mesh, problem_->conditions, state.nodes.x);
    table_.emplace(context_.folder / "energy.dat", context_.precision, context_.resumeAt);
    table_->comment("Energy, dissipation and work since the beginning [J/m in 2D, J in 3D]");
    table_->header({"Time", "kinetic", "elastic", "potential", "total", "viscous", "damper", "workWalls", "workLoads",
                    textOf(EnergyCause::remeshing).name, textOf(EnergyCause::volume).name, "numerical"});
}

template <int Dim>
void Energy<Dim>::advance(const State<Dim>& state) {
    const double dt = state.time.value - time_;
    if (!(dt > 0)) return;
    const auto powers = energyPowers<Dim>(problemAt<Dim>(state.time.value, *problem_), controls_, state);
    flows_.viscous += 0.5 * dt * (powers_.viscous + powers.viscous);
    flows_.damper += 0.5 * dt * (powers_.damper + powers.damper);
    flows_.workWalls += 0.5 * dt * (powers_.walls + powers.walls);
    flows_.workLoads += 0.5 * dt * (powers_.drive + powers.drive);
    auto loads = tractionForce<Dim>(state.mesh, problem_->conditions, state.nodes.x);
    for (std::size_t i = 0; i < loads.size(); ++i) {  // only nodes of solids have loads, and these stay
        if (loads[i].isZero(0)) continue;
        const auto at = std::lower_bound(ids_.begin(), ids_.end(), state.nodes.id[i]);
        if (at == ids_.end() || *at != state.nodes.id[i]) continue;
        const auto k = at - ids_.begin();
        flows_.workLoads += 0.5 * (loads_[k] + loads[i]).dot(state.nodes.x[i] - x_[k]);
    }
    time_ = state.time.value;
    powers_ = powers;
    ids_ = state.nodes.id;
    x_ = state.nodes.x;
    loads_ = std::move(loads);
}

template <int Dim>
void Energy<Dim>::execute(const State<Dim>& state) {
    const auto energy = storedEnergy<Dim>(*problem_, controls_, state);
    const double remeshing = state.energy[EnergyCause::remeshing] - firstRemeshing_;
    const double volume = state.energy[EnergyCause::volume] - firstVolume_;
    const double numerical = first_ + flows_.workWalls + flows_.workLoads + remeshing + volume - energy.total() -
                             flows_.viscous - flows_.damper;
    std::vector<std::string> row{table_->time(state.time.value)};
    for (const double value : {energy.kinetic, energy.elastic, energy.potential, energy.total(), flows_.viscous,
                               flows_.damper, flows_.workWalls, flows_.workLoads, remeshing, volume, numerical})
        row.push_back(table_->number(value));
    table_->row(row);
}

template <int Dim>
std::vector<double> Energy<Dim>::memory() const {
    return {first_, flows_.viscous, flows_.damper, flows_.workWalls, flows_.workLoads, firstRemeshing_, firstVolume_};
}

#define PFEM_INSTANTIATE(D) template class Energy<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
