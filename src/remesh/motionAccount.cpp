#include "remesh/motionAccount.hpp"

#include <numeric>

#include "state/volume.hpp"

namespace pfem {

template <int Dim>
MotionAccount<Dim>::MotionAccount(const State<Dim>& state)
    : volume_(cellVolume<Dim>(state.nodes.x, state.mesh.fluid.nodes)) {
    if (!state.appeared.empty()) x_ = state.nodes.x;
}

template <int Dim>
void MotionAccount<Dim>::book(const std::string& cause, State<Dim>& state) {
    state.ledger[cause] += change(cause, state);
}

template <int Dim>
void MotionAccount<Dim>::bookSolver(const std::vector<double>& returned, const std::vector<double>& compressed,
                                    State<Dim>& state) {
    const double correction = bookPart("correction", returned, state),
                 compression = bookPart("compression", compressed, state);
    state.ledger["solver"] += change("solver", state) - correction - compression;
}

template <int Dim>
double MotionAccount<Dim>::bookPart(const std::string& cause, const std::vector<double>& amounts, State<Dim>& state) {
    const double sum = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    state.ledger[cause] += sum;
    if (x_.empty()) return sum;
    auto &solver = state.appeared.at("solver"), &field = state.appeared.at(cause);
    for (std::size_t i = 0; i < amounts.size(); ++i) {
        solver[i] -= amounts[i];
        field[i] += amounts[i];
    }
    return sum;
}

template <int Dim>
double MotionAccount<Dim>::change(const std::string& cause, State<Dim>& state) {
    const auto& cells = state.mesh.fluid.nodes;
    const double before = volume_;
    volume_ = cellVolume<Dim>(state.nodes.x, cells);
    if (x_.empty()) return volume_ - before;
    auto& amounts = state.appeared.at(cause);
    for (const auto& cell : cells) {
        const double part = (simplexMeasure<Dim>(state.nodes.x, cell) - simplexMeasure<Dim>(x_, cell)) / (Dim + 1);
        for (const int node : cell) amounts[node] += part;
    }
    x_ = state.nodes.x;
    return volume_ - before;
}

template class MotionAccount<2>;

}  // namespace pfem
