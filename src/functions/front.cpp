#include "functions/front.hpp"

#include <algorithm>

#include "base/vectors.hpp"
#include "dictionary/function1.hpp"
#include "functions/sensors.hpp"
#include "mesh/components.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

template <int Dim>
std::optional<FrontReading> readFront(const State<Dim>& state, const Vec<Dim>& direction) {
    const auto& x = state.nodes.x;
    const auto& cells = state.mesh.fluid.nodes;
    if (cells.empty()) return {};
    const auto piece = components(cells, state.nodes.size());
    std::vector<double> share(x.size(), 0.0), volume(x.size(), 0.0);
    std::vector<unsigned char> wet(x.size(), 0);
    for (const auto& cell : cells) {
        for (const int node : cell) wet[node] = 1;
        share[cell[0]] += simplexMeasure<Dim>(x, cell);
    }
    for (int i = 0; i < state.nodes.size(); ++i) volume[piece[i]] += share[i];
    const int main = static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());

    FrontReading front;
    bool first = true;
    const auto consider = [&](int node, bool connected) {
        const double place = x[node].dot(direction);
        front.any = first ? place : std::max(front.any, place);
        first = false;
        if (connected && (front.node < 0 || place > front.connected)) front.connected = place, front.node = node;
    };
    for (int i = 0; i < state.nodes.size(); ++i)
        if (wet[i]) consider(i, piece[i] == main);
    for (int i = 0; i < state.nodes.size(); ++i)
        if (state.nodes.dropVolume[i] > 0) consider(i, false);
    return front;
}

template <int Dim>
Front<Dim>::Front(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    if (!(entries_.direction.template head<Dim>().norm() > 0)) dict.fatal("direction", "the direction has no length");
    if (Dim == 2) demandPlane(dict, "direction", entries_.direction[2]);
}

template <int Dim>
void Front<Dim>::start(const State<Dim>&) {
    table_.emplace(context_.folder / "front.dat", context_.precision, context_.resumeAt);
    table_->comment("Largest x . direction of the main body of fluid and of any fluid [m]; where the first is");
    table_->header({"Time", "front", "any", "location"});
}

template <int Dim>
void Front<Dim>::execute(const State<Dim>& state) {
    const auto front = readFront<Dim>(state, entries_.direction.template head<Dim>().normalized());
    std::vector<double> place{dry, dry, dry};
    if (front) place = threeNumbers<Dim>(state.nodes.x[front->node]);
    table_->row({table_->time(state.time.value), table_->number(front ? front->connected : dry),
                 table_->number(front ? front->any : dry), table_->tuple(place)});
}

#define PFEM_INSTANTIATE(D)                                                            \
    template std::optional<FrontReading> readFront<D>(const State<D>&, const Vec<D>&); \
    template class Front<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
