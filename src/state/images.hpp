#pragma once
// Periodic sides: nodes beyond them are images of others. They are the last ones of a state, and their names say of
// whom: id = code firstImage + the master's id, with the code of the shift below. Nothing else is written of them.

#include <algorithm>
#include <array>
#include <cmath>

#include "state/state.hpp"

namespace pfem {

/// No other node has so high an id.
inline constexpr Id firstImage = Id{1} << 56;

/// By how many periods (-1, 0, 1) in each direction.
template <int Dim>
using Shift = std::array<int, Dim>;

/// The box that repeats itself; directions in which it does not have the length 0.
template <int Dim>
struct Period {
    Vec<Dim> from = Vec<Dim>::Zero(), length = Vec<Dim>::Zero();  // [m]

    bool any() const { return (length.array() > 0).any(); }
    /// The way of so many periods.
    Vec<Dim> times(const Shift<Dim>& shift) const {
        Vec<Dim> way;
        for (int k = 0; k < Dim; ++k) way[k] = shift[k] * length[k];
        return way;
    }
};

/// Coordinates between sides are multiples of it, a power of two, so that shifts by a period are exact.
inline double grainOf(double from, double length) {
    return std::ldexp(1.0, std::ilogb(std::abs(from) + 2 * length) - 50);
}

/// 0: no shift; each direction is a digit 0, 1, 2 for 0, 1, -1 periods.
template <int Dim>
int codeOf(const Shift<Dim>& shift);
template <int Dim>
Shift<Dim> shiftOf(int code);

/// How many nodes are no images.
template <int Dim>
int nOwnNodes(const State<Dim>& state) {
    const auto& id = state.nodes.id;
    return static_cast<int>(std::lower_bound(id.begin(), id.end(), firstImage) - id.begin());
}

/// Of a cell or face and its copies, shifted by periods, one counts: that whose node with the lowest master is no
/// image. `id`: of all nodes.
template <class NodeList>
bool isOwn(const std::vector<Id>& id, const NodeList& nodes) {
    const int lowest = *std::min_element(nodes.begin(), nodes.end(),
                                         [&](int i, int j) { return id[i] % firstImage < id[j] % firstImage; });
    return id[lowest] < firstImage;
}

/// How many cells of the fluid count: all, but for the copies that follow them within a step (unfolding.hpp).
template <int Dim>
int nOwnCells(const State<Dim>& state) {
    const auto& cells = state.mesh.fluid.nodes;
    if (nOwnNodes<Dim>(state) == state.nodes.size()) return state.mesh.fluid.size();
    return static_cast<int>(std::partition_point(cells.begin(), cells.end(),
                                                 [&](const auto& cell) { return isOwn(state.nodes.id, cell); }) -
                            cells.begin());
}

/// Who is whose image.
template <int Dim>
struct Images {
    int nOwn = 0;             // nodes before the images
    std::vector<int> master;  // per node, itself if it is no image; empty: there are no images
    std::vector<int> code;    // of the image's shift, per node

    bool empty() const { return master.empty(); }
    bool isImage(int i) const { return !empty() && i >= nOwn; }
    int own(int i) const { return empty() ? i : master[i]; }
    /// The node that is a master shifted so; -1: none.
    int find(int ofMaster, int withCode) const;

    /// Images get what their masters have.
    template <class Value>
    void follow(std::vector<Value>& values) const {
        for (std::size_t i = nOwn; i < master.size(); ++i) values[i] = values[master[i]];
    }
    /// Images have nothing.
    template <class Value>
    void hide(std::vector<Value>& values) const {
        for (std::size_t i = nOwn; i < master.size(); ++i) values[i] = Value();
    }
    template <class Value>
    std::vector<Value> counted(std::vector<Value> values) const {
        hide(values);
        return values;
    }
};

template <int Dim>
Images<Dim> imagesOf(const State<Dim>& state);

/// Is every node below nextId, or an image whose master is there and has its velocity and pressure?
template <int Dim>
bool namesAreValid(const State<Dim>& state);

/// All shifts to images.
template <int Dim>
std::vector<Shift<Dim>> shiftsOf(const Period<Dim>& period);

}  // namespace pfem
