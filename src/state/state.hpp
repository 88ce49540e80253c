#pragma once
// All that a run knows at one instant; a time folder holds exactly this, but for the ledger's fields. Only nodes carry
// history, and with elemental integration the solid's cells (Cells::sigma, Cells::history), which last for the whole
// run.

#include <map>
#include <string>
#include <vector>

#include "base/history.hpp"
#include "base/types.hpp"
#include "case/timeInfo.hpp"
#include "mesh/mesh.hpp"
#include "state/energyCauses.hpp"
#include "state/volumeLedger.hpp"

namespace pfem {

/// Nodal values, all arrays of one length, sorted by ascending id. Nodes of fluid and solid and corners of walls share
/// the one list; an interface node is ONE node with one velocity.
template <int Dim>
struct Nodes {
    std::vector<Id> id;
    Points<Dim> x;                   // position [m]
    Points<Dim> v;                   // velocity [m/s]
    Points<Dim> a;                   // acceleration [m/s2]
    std::vector<double> p;           // fluid pressure, positive in compression [Pa]
    std::vector<Stress<Dim>> sigma;  // Cauchy stress of the solid patch [Pa] (elemental: mean of cells), else zero
    Points<Dim> X;                   // reference position; D = x - X [m]
    std::vector<double> h;           // wanted distance to the neighbours [m]
    std::vector<double> dropVolume;  // volume carried by an isolated particle [m2 (2D), m3]
    std::vector<double> lostVolume;  // what the fluid around the node has lost and not got back; < 0: gained
    std::vector<int> wall;           // the wall face along which the node slides (counted over all patches) or -1
    History history;                 // of the solids' laws (elemental: mean of cells); nothing when none has any

    int size() const { return static_cast<int>(id.size()); }
    void resize(int n);

    /// Append node i of another set.
    void append(const Nodes& other, int i);

    /// The nodes with these indices, in their order.
    Nodes taken(const std::vector<int>& indices) const;
};

template <int Dim>
struct State {
    TimeInfo time;
    Nodes<Dim> nodes;
    Mesh<Dim> mesh;
    Id nextId = 0;        // the id of the next node to be inserted
    double approach = 0;  // how fast surfaces that are about to meet, or have just met, close: largest -div v of the
                          // triangles between [1/s]
    VolumeLedger ledger;  // cumulative fluid volume by cause; its fields, if any, are those since the last time folder:
                          // a run that goes on begins with zeros, for it begins with a time folder
    EnergyLedger energy;  // what came beside the equations of motion, by cause
    std::map<std::string, std::vector<double>> memory;  // of function objects, by their name
};

template <int Dim>
void Nodes<Dim>::resize(int n) {
    const auto m = static_cast<std::size_t>(n);
    id.resize(m, -1);
    x.resize(m, Vec<Dim>::Zero());
    v.resize(m, Vec<Dim>::Zero());
    a.resize(m, Vec<Dim>::Zero());
    p.resize(m, 0.0);
    sigma.resize(m, Stress<Dim>::Zero());
    X.resize(m, Vec<Dim>::Zero());
    h.resize(m, 0.0);
    dropVolume.resize(m, 0.0);
    lostVolume.resize(m, 0.0);
    wall.resize(m, -1);
    history.resize(n);
}

template <int Dim>
void Nodes<Dim>::append(const Nodes& other, int i) {
    id.push_back(other.id[i]);
    x.push_back(other.x[i]);
    v.push_back(other.v[i]);
    a.push_back(other.a[i]);
    p.push_back(other.p[i]);
    sigma.push_back(other.sigma[i]);
    X.push_back(other.X[i]);
    h.push_back(other.h[i]);
    dropVolume.push_back(other.dropVolume[i]);
    lostVolume.push_back(other.lostVolume[i]);
    wall.push_back(other.wall[i]);
    history.append(other.history, i);
}

template <int Dim>
Nodes<Dim> Nodes<Dim>::taken(const std::vector<int>& indices) const {
    Nodes result;
    const auto take = [&](auto& to, const auto& from) {
        to.reserve(indices.size() + indices.size() / 64);  // a few are going to be inserted
        for (int i : indices) to.push_back(from[i]);
    };
    take(result.id, id);
    take(result.x, x);
    take(result.v, v);
    take(result.a, a);
    take(result.p, p);
    take(result.sigma, sigma);
    take(result.X, X);
    take(result.h, h);
    take(result.dropVolume, dropVolume);
    take(result.lostVolume, lostVolume);
    take(result.wall, wall);
    result.history = history.taken(indices);
    return result;
}

}  // namespace pfem
