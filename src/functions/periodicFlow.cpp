#include "functions/periodicFlow.hpp"

#include "base/vectors.hpp"
#include "functions/balance.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
FluidFlow<Dim> fluidFlow(const State<Dim>& state) {
    FluidFlow<Dim> flow;
    for (int e = 0; e < nOwnCells<Dim>(state); ++e) {
        const auto& cell = state.mesh.fluid.nodes[e];
        const double measure = simplexMeasure<Dim>(state.nodes.x, cell);
        for (const int i : cell) flow.integral += measure / (Dim + 1) * state.nodes.v[i];
        flow.volume += measure;
    }
    return flow;
}

template <int Dim>
PeriodicFlow<Dim>::PeriodicFlow(const Dictionary& dict, const FunctionContext<Dim>& context)
    : context_(context), where_(dict.where()) {}

template <int Dim>
void PeriodicFlow<Dim>::start(const State<Dim>& state) {
    problem_ = readProblem<Dim>(Case(context_.root), state, nullptr);
    controls_ = readControls(Case(context_.root), nullptr);
    if (!problem_->period.any())
        throw UserError("the function '" + context_.name +
                            "' is of type periodicFlow, but there are no periodic sides (constant/periodic)",
                        where_);
    table_.emplace(context_.folder / "periodicFlow.dat", context_.precision, context_.resumeAt);
    table_->comment(
        "Flow through periodic sides [m2/s (2D), m3/s], mean velocity [m/s], acceleration of the force that holds it "
        "[m/s2]");
    table_->header({"Time", "flowRate", "meanVelocity", "drive"});
}

template <int Dim>
void PeriodicFlow<Dim>::execute(const State<Dim>& state) {
    const auto flow = fluidFlow<Dim>(state);
    Vec<Dim> rate = Vec<Dim>::Zero(), mean = Vec<Dim>::Zero();
    for (int k = 0; k < Dim; ++k)
        if (problem_->period.length[k] > 0) rate[k] = flow.integral[k] / problem_->period.length[k];
    if (flow.volume > 0) mean = flow.integral / flow.volume;
    std::vector<std::string> row{table_->time(state.time.value)};
    for (const Vec<Dim>& value : {rate, mean, driveOf<Dim>(*problem_, controls_, state)})
        row.push_back(table_->tuple(threeNumbers<Dim>(value)));
    table_->row(row);
}

#define PFEM_INSTANTIATE(D)                              \
    template FluidFlow<D> fluidFlow<D>(const State<D>&); \
    template class PeriodicFlow<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
