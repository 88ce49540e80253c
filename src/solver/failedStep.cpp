#include "solver/failedStep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/simplex.hpp"
#include "state/images.hpp"

namespace pfem {

namespace {

/// Make the numbers of node i finite; true when they were not.
template <int Dim>
bool mend(Nodes<Dim>& nodes, int i, const Nodes<Dim>& last) {
    const auto finite = [](const auto& u) { return u.allFinite(); };
    bool mended = false;
    if (!finite(nodes.x[i])) {
        const auto before = std::lower_bound(last.id.begin(), last.id.end(), nodes.id[i]);
        const bool known = before != last.id.end() && *before == nodes.id[i];
        nodes.x[i] = known ? last.x[before - last.id.begin()] : nodes.X[i];
        mended = true;
    }
    for (auto* u : {&nodes.v[i], &nodes.a[i]})
        if (!finite(*u)) {
            u->setZero();
            mended = true;
        }
    if (!finite(nodes.sigma[i])) {
        nodes.sigma[i].setZero();
        mended = true;
    }
    if (!std::isfinite(nodes.p[i])) {
        nodes.p[i] = 0;
        mended = true;
    }
    return mended;
}

template <int Dim>
void flagFastest(const Nodes<Dim>& nodes, std::vector<unsigned char>& failed) {
    const auto fastest = std::max_element(
        nodes.v.begin(), nodes.v.end(), [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
    if (fastest != nodes.v.end()) failed[fastest - nodes.v.begin()] = 1;
}

}  // namespace

template <int Dim>
std::string placeText(const Vec<Dim>& x) {
    std::string text = "(";
    for (int c = 0; c < Dim; ++c) text += fmt::format("{}{:.6g}", c > 0 ? " " : "", x[c]);
    return text + ")";
}

template <int Dim>
void failAt(const Nodes<Dim>& nodes, int i, const std::string& what) {
    throw StepFailure(fmt::format("node {} at {} {}", nodes.id[i], placeText<Dim>(nodes.x[i]), what), {nodes.id[i]});
}

template <int Dim>
State<Dim> withNodesOf(State<Dim> last, const Nodes<Dim>& nodes) {
    for (int i = 0, j = 0; i < last.nodes.size(); ++i) {  // both sorted by id
        while (j < nodes.size() && nodes.id[j] < last.nodes.id[i]) ++j;
        if (j == nodes.size() || nodes.id[j] != last.nodes.id[i]) continue;
        Nodes<Dim>::fields([&, to = i, from = j](const char*, auto field, const auto&, auto) {
            (last.nodes.*field)[to] = (nodes.*field)[from];
        });
    }
    return last;
}

template <int Dim>
Inspection<Dim> inspect(const FailedStep<Dim>& failure, const State<Dim>& last) {
    Inspection<Dim> result{failure.trial(), {}, ""};
    State<Dim>& state = result.state;
    Nodes<Dim>& nodes = state.nodes;
    result.failed.assign(nodes.id.size(), 0);
    for (int i = 0; i < nodes.size(); ++i) result.failed[i] = mend(nodes, i, last.nodes);
    for (auto& sigma : state.mesh.solid.sigma)
        if (!sigma.allFinite()) sigma.setZero();
    for (auto* history : {&state.nodes.history, &state.mesh.solid.history})
        for (double& value : history->values)
            if (!std::isfinite(value)) value = 0;
    for (const auto& cell : state.mesh.solid.nodes)
        if (!(simplexMeasure<Dim>(nodes.x, cell) > 0))
            for (int i : cell) result.failed[i] = 1;
    for (const Id id : failure.nodes()) {
        const auto found = std::lower_bound(nodes.id.begin(), nodes.id.end(), id);
        if (found != nodes.id.end() && *found == id) result.failed[found - nodes.id.begin()] = 1;
    }
    if (std::count(result.failed.begin(), result.failed.end(), 0) == nodes.size()) flagFastest(nodes, result.failed);

    state.time = last.time;
    const auto images = std::lower_bound(nodes.id.begin(), nodes.id.end(), firstImage);
    state.nextId = std::max(last.nextId, images == nodes.id.begin() ? 0 : *(images - 1) + 1);
    state.ledger = last.ledger;
    state.approach = last.approach;
    state.energy = last.energy;
    state.ledger.stopCounting();  // its nodes are those of the last state
    int named = 0;
    for (int i = 0; i < nodes.size(); ++i) {
        if (!result.failed[i] || ++named > 5) continue;
        result.text += fmt::format("    node {} at {}, |U| = {:.3g} m/s, p = {:.3g} Pa\n", nodes.id[i],
                                   placeText<Dim>(nodes.x[i]), nodes.v[i].norm(), nodes.p[i]);
    }
    if (named > 5) result.text += fmt::format("    and {} more\n", named - 5);
    return result;
}

#define PFEM_INSTANTIATE(D)                                            \
    template State<D> withNodesOf<D>(State<D>, const Nodes<D>&);       \
    template std::string placeText<D>(const Vec<D>&);                  \
    template void failAt<D>(const Nodes<D>&, int, const std::string&); \
    template Inspection<D> inspect<D>(const FailedStep<D>&, const State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
