#include "state/unfolding.hpp"

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "mesh/topology.hpp"

namespace pfem {

namespace {

template <int Dim>
double largestSize(const Nodes<Dim>& nodes) {
    return nodes.h.empty() ? 0 : *std::max_element(nodes.h.begin(), nodes.h.end());
}

/// Is a point within the box and its bands?
template <int Dim>
bool isNear(const Period<Dim>& period, const Vec<Dim>& x, double width) {
    for (int k = 0; k < Dim; ++k)
        if (period.length[k] > 0 && (x[k] < period.from[k] - width || x[k] > period.from[k] + period.length[k] + width))
            return false;
    return true;
}

/// Nodes that slide on a wall go on over its faces.
template <int Dim>
void placeOnWalls(const Sides<Dim>& sides, int i, Nodes<Dim>& nodes) {
    for (int& wall : nodes.wall[i])
        if (wall >= 0) wall = placeOnRegion<Dim>(sides.walls, sides.points, wall, nodes.x[i]).face;
}

/// The nodes with these indices; what is not among them must not be in cells.
template <int Dim>
void takeNodes(const std::vector<int>& taken, State<Dim>& state) {
    std::vector<int> newIndex(state.nodes.size(), -1);
    for (std::size_t k = 0; k < taken.size(); ++k) newIndex[taken[k]] = static_cast<int>(k);
    for (auto& cell : state.mesh.fluid.nodes)
        for (int& node : cell) node = newIndex[node];
    for (auto& [cause, amounts] : state.ledger.fields()) {
        std::vector<double> of;
        for (const int i : taken) of.push_back(amounts[i]);
        amounts = std::move(of);
    }
    state.nodes = state.nodes.taken(taken);
}

/// 0 ... n - 1.
std::vector<int> firstNodes(int n) {
    std::vector<int> list(n);
    std::iota(list.begin(), list.end(), 0);
    return list;
}

}  // namespace

template <int Dim>
std::vector<Shift<Dim>> comeBack(const Sides<Dim>& sides, State<Dim>& state) {
    const auto& period = sides.period;
    auto& nodes = state.nodes;
    const auto kept = keptNodes<Dim>(state.mesh, nodes.size());
    std::vector<Shift<Dim>> moved(nodes.size(), Shift<Dim>{});
    const int n = nOwnNodes<Dim>(state);
    for (int i = 0; i < n; ++i) {
        if (kept[i]) continue;
        for (int k = 0; k < Dim; ++k) {
            if (period.length[k] == 0) continue;
            const double grain = grainOf(period.from[k], period.length[k]);
            moved[i][k] = -static_cast<int>(std::floor((nodes.x[i][k] - period.from[k]) / period.length[k]));
            nodes.x[i][k] = std::round((nodes.x[i][k] + moved[i][k] * period.length[k]) / grain) * grain;
        }
        if (moved[i] != Shift<Dim>{}) placeOnWalls<Dim>(sides, i, nodes);
    }
    return moved;
}

template <int Dim>
void setImages(const Sides<Dim>& sides, State<Dim>& state) {
    const auto old = imagesOf<Dim>(state);
    const auto& period = sides.period;
    const double width = bandWidth * largestSize<Dim>(state.nodes);
    const auto kept = keptNodes<Dim>(state.mesh, state.nodes.size());
    const Nodes<Dim> before = state.nodes;
    state.nodes = before.taken(firstNodes(old.nOwn));
    Nodes<Dim>& nodes = state.nodes;
    for (const auto& shift : shiftsOf<Dim>(period))
        for (int i = 0; i < old.nOwn; ++i) {
            const Vec<Dim> x = before.x[i] + period.times(shift);
            if (kept[i] || !isNear<Dim>(period, x, width)) continue;
            nodes.append(before, i);
            nodes.id.back() += codeOf<Dim>(shift) * firstImage;
            nodes.x.back() = x;
            placeOnWalls<Dim>(sides, nodes.size() - 1, nodes);
        }
    const auto images = imagesOf<Dim>(state);
    for (auto& cell : state.mesh.fluid.nodes)
        for (int& node : cell) {
            const int now = old.empty() ? node : images.find(old.master[node], old.code[node]);
            if (now < 0) throw StepFailure("a cell reaches farther than the bands beyond periodic sides");
            node = now;
        }
}

template <int Dim>
void setCopies(const Sides<Dim>& sides, State<Dim>& state) {
    const auto images = imagesOf<Dim>(state);
    auto& cells = state.mesh.fluid.nodes;
    auto& material = state.mesh.fluid.material;
    const std::vector<Simplex<Dim>> all = std::move(cells);
    const std::vector<int> materials = std::move(material);
    cells.clear();
    material.clear();
    for (std::size_t e = 0; e < all.size(); ++e) {
        if (!isOwn(state.nodes.id, all[e])) continue;
        cells.push_back(all[e]);
        material.push_back(materials[e]);
    }
    const std::size_t nOwn = cells.size();
    for (const auto& shift : shiftsOf<Dim>(sides.period))
        for (std::size_t e = 0; e < nOwn; ++e) {
            Simplex<Dim> copy = cells[e];
            for (int& node : copy) {
                Shift<Dim> sum = shiftOf<Dim>(images.empty() ? 0 : images.code[node]);
                bool far = false;
                for (int k = 0; k < Dim; ++k) far = far || std::abs(sum[k] += shift[k]) > 1;
                node = far || images.empty() ? -1 : images.find(images.master[node], codeOf<Dim>(sum));
                if (node < 0) break;
            }
            if (std::any_of(copy.begin(), copy.end(), [](int node) { return node < 0; })) continue;
            cells.push_back(copy);
            material.push_back(material[e]);
        }
}

template <int Dim>
void keepImages(const Sides<Dim>& sides, State<Dim>& state) {
    const auto images = imagesOf<Dim>(state);
    auto& nodes = state.nodes;
    const std::vector<Id> id = nodes.id;
    Nodes<Dim>::fields([&](const char*, auto field, const auto&, auto) { images.follow(nodes.*field); });
    nodes.id = id;
    for (int i = images.nOwn; i < nodes.size(); ++i) {
        nodes.x[i] += sides.period.times(shiftOf<Dim>(images.code[i]));
        placeOnWalls<Dim>(sides, i, nodes);
    }
}

template <int Dim>
State<Dim> unfolded(const Sides<Dim>& sides, State<Dim> state) {
    setImages<Dim>(sides, state);
    setCopies<Dim>(sides, state);
    for (auto& [cause, amounts] : state.ledger.fields()) amounts.resize(state.nodes.size(), 0.0);
    return state;
}

template <int Dim>
State<Dim> folded(State<Dim> state) {
    const auto images = imagesOf<Dim>(state);
    if (images.empty()) return state;
    const int nCells = nOwnCells<Dim>(state);
    state.mesh.fluid.nodes.resize(nCells);
    state.mesh.fluid.material.resize(nCells);
    auto& nodes = state.nodes;
    for (int i = images.nOwn; i < nodes.size(); ++i) {
        nodes.lostVolume[i] = nodes.dropVolume[i] = 0;
        for (auto& [cause, amounts] : state.ledger.fields())
            amounts[images.master[i]] += std::exchange(amounts[i], 0.0);
    }
    const auto used = nodesIn<Dim>(state.mesh.fluid.nodes, nodes.size());
    auto taken = firstNodes(images.nOwn);
    for (int i = images.nOwn; i < nodes.size(); ++i)
        if (used[i]) taken.push_back(i);
    takeNodes<Dim>(taken, state);
    return state;
}

#define PFEM_INSTANTIATE(D)                                                 \
    template std::vector<Shift<D>> comeBack<D>(const Sides<D>&, State<D>&); \
    template void setImages<D>(const Sides<D>&, State<D>&);                 \
    template void setCopies<D>(const Sides<D>&, State<D>&);                 \
    template void keepImages<D>(const Sides<D>&, State<D>&);                \
    template State<D> unfolded<D>(const Sides<D>&, State<D>);               \
    template State<D> folded<D>(State<D>);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
