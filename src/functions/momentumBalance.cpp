#include "functions/momentumBalance.hpp"

#include <algorithm>
#include <numeric>

#include "solver/setup.hpp"

namespace pfem {

template <int Dim>
MomentumBalance<Dim>::MomentumBalance(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    const auto entries = readEntries<MomentumBalanceEntries>(dict);
    const Eigen::Vector3d way = entries.to - entries.from;
    if (!(way.norm() > 0)) dict.fatal("to", "'from' and 'to' are the same place");
    if (Dim == 2) demandPlane(dict, "to", way[2]);
    volume_ = {entries.from.head<Dim>(), way.head<Dim>().normalized(), way.norm(), entries.width};
}

template <int Dim>
void MomentumBalance<Dim>::start(const State<Dim>& state) {
    problem_ = readProblem<Dim>(Case(context_.root), state, nullptr);
    controls_ = readControls(Case(context_.root), nullptr);
    if (volume_.width == 0 && state.nodes.size() > 0)
        volume_.width = 4 * *std::max_element(state.nodes.h.begin(), state.nodes.h.end());
    first_ = momentumIn<Dim>(*problem_, state, volume_);
    sums_ = {};
    const auto found = state.memory.find(context_.name);
    if (found != state.memory.end() && found->second.size() == 2 + sums_.size()) {
        first_ = found->second[0];
        volume_.width = found->second[1];
        std::copy(found->second.begin() + 2, found->second.end(), sums_.begin());
    }
    time_ = state.time.value;
    rates_ = momentumRates<Dim>(*problem_, controls_, state, volume_).all();
    table_.emplace(context_.folder / "momentumBalance.dat", context_.precision, context_.resumeAt);
    table_->comment(
        "Momentum of the fluid in the control volume, and what has come into it since the beginning [N s/m (2D), N s]");
    table_->header({"Time", "momentum", "flowFrom", "flowTo", "pressureFrom", "pressureTo", "walls", "gravity",
                    "viscous", "numerical"});
}

template <int Dim>
void MomentumBalance<Dim>::advance(const State<Dim>& state) {
    const double dt = state.time.value - time_;
    if (!(dt > 0)) return;
    const auto rates = momentumRates<Dim>(*problem_, controls_, state, volume_).all();
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] += 0.5 * dt * (rates_[k] + rates[k]);
    rates_ = rates;
    time_ = state.time.value;
}

template <int Dim>
void MomentumBalance<Dim>::execute(const State<Dim>& state) {
    const double momentum = momentumIn<Dim>(*problem_, state, volume_);
    std::vector<std::string> row{table_->time(state.time.value), table_->number(momentum)};
    for (const double sum : sums_) row.push_back(table_->number(sum));
    row.push_back(table_->number(momentum - first_ - std::accumulate(sums_.begin(), sums_.end(), 0.0)));
    table_->row(row);
}

template <int Dim>
std::vector<double> MomentumBalance<Dim>::memory() const {
    std::vector<double> numbers{first_, volume_.width};
    numbers.insert(numbers.end(), sums_.begin(), sums_.end());
    return numbers;
}

template class MomentumBalance<2>;
template class MomentumBalance<3>;

}  // namespace pfem
