#pragma once
// What is known of the nodes. Only nodes carry history, and with elemental integration the solid's cells.

#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/history.hpp"
#include "base/types.hpp"
#include "mesh/supports.hpp"

namespace pfem {

/// Nodal values, all arrays of one length, sorted by ascending id. Nodes of fluid and solid and points of walls share
/// the one list; an interface node is ONE node with one velocity.
template <int Dim>
struct Nodes {
    std::vector<Id> id;
    Points<Dim> x;                    // position [m]
    Points<Dim> v;                    // velocity [m/s]
    Points<Dim> a;                    // acceleration [m/s2]
    std::vector<double> p;            // fluid pressure, positive in compression [Pa]
    Points<Dim> X;                    // reference position; D = x - X [m]
    std::vector<Stress<Dim>> sigma;   // Cauchy stress of the solid patch [Pa] (elemental: mean of cells), else zero
    std::vector<double> h;            // wanted distance to the neighbours [m]
    std::vector<double> dropVolume;   // volume carried by an isolated particle [m2 (2D), m3]
    std::vector<double> lostVolume;   // what the fluid around the node has lost and not got back; < 0: gained
    std::vector<Supports<Dim>> wall;  // the wall faces that hold the node (counted over all patches)
    History history;                  // of the solids' laws (elemental: mean of cells); nothing when none has any

    /// What a node that is made between two others gets: their mean, or the field's first value.
    enum class Between { mean, first };

    /// The one list of fields (but the history), in the order of the files: visit(name of the array, member, first
    /// value, Between). A new field is its member above and its line here: it is then written, read, compared and
    /// carried through remeshing.
    template <class Visitor>
    static void fields(Visitor&& visit) {
        const Vec<Dim> zero = Vec<Dim>::Zero();
        const Stress<Dim> unstressed = Stress<Dim>::Zero();
        visit("id", &Nodes::id, Id{-1}, Between::first);
        visit("Points", &Nodes::x, zero, Between::mean);
        visit("U", &Nodes::v, zero, Between::mean);
        visit("a", &Nodes::a, zero, Between::mean);
        visit("p", &Nodes::p, 0.0, Between::mean);
        visit("X", &Nodes::X, zero, Between::first);
        visit("sigma", &Nodes::sigma, unstressed, Between::first);
        visit("h", &Nodes::h, 0.0, Between::mean);
        visit("dropVolume", &Nodes::dropVolume, 0.0, Between::first);
        visit("lostVolume", &Nodes::lostVolume, 0.0, Between::first);
        visit("wall", &Nodes::wall, unsupported<Dim>(), Between::first);
    }

    int size() const { return static_cast<int>(id.size()); }
    void resize(int n);

    /// Append node i of another set.
    void append(const Nodes& other, int i);

    /// Append a node between nodes i and j of another set.
    void appendBetween(const Nodes& other, int i, int j);

    /// The nodes with these indices, in their order.
    Nodes taken(const std::vector<int>& indices) const;
};

template <int Dim>
void Nodes<Dim>::resize(int n) {
    fields([&](const char*, auto field, const auto& first, Between) {
        (this->*field).resize(static_cast<std::size_t>(n), first);
    });
    history.resize(n);
}

template <int Dim>
void Nodes<Dim>::append(const Nodes& other, int i) {
    fields([&](const char*, auto field, const auto&, Between) { (this->*field).push_back((other.*field)[i]); });
    history.append(other.history, i);
}

template <int Dim>
void Nodes<Dim>::appendBetween(const Nodes& other, int i, int j) {
    fields([&](const char*, auto field, const auto& first, Between between) {
        auto value = first;
        if constexpr (!std::is_same_v<decltype(value), Supports<Dim>>)
            if (between == Between::mean) value = 0.5 * ((other.*field)[i] + (other.*field)[j]);
        (this->*field).push_back(value);
    });
    history.resize(size());
}

template <int Dim>
Nodes<Dim> Nodes<Dim>::taken(const std::vector<int>& indices) const {
    Nodes result;
    fields([&](const char*, auto field, const auto&, Between) {
        auto& to = result.*field;
        to.reserve(indices.size() + indices.size() / 64);  // a few are going to be inserted
        for (int i : indices) to.push_back((this->*field)[i]);
    });
    result.history = history.taken(indices);
    return result;
}

}  // namespace pfem
