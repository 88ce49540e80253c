#pragma once
// Stress points: where strain rates are taken and stress lives. The ONE difference between nodal and elemental
// integration; what is written in these terms serves both.
//
//   nodal:      the points are the nodes; gradients are means over their domains, G_IJ of (13)-(17)
//   elemental:  the points are the elements; every mean below is the identity

#include "integration/smoothingDomains.hpp"

namespace pfem {

/// Is the stress of a point that of several cells, so that bodies whose laws answer to different strains cannot share
/// nodes?
inline bool mixesCells(Integration scheme) { return scheme == Integration::nodal; }

/// The same domains with the nodes as stress points.
template <int Dim>
SmoothingDomains<Dim> withNodalPoints(SmoothingDomains<Dim> domains) {
    domains.scheme = Integration::nodal;
    return domains;
}

/// Length of a field on the stress points; nodal: all nodes of the mesh, those outside the material included.
template <int Dim>
int nStressPoints(const SmoothingDomains<Dim>& domains) {
    return domains.scheme == Integration::nodal ? domains.nNodes() : domains.nCells();
}

/// work(p) for the points of this process's share; as parallelFor.
template <int Dim, class Work>
void forPoints(const SmoothingDomains<Dim>& domains, const Work& work) {
    if (domains.scheme == Integration::nodal)
        domains.share.forNodes(domains.nNodes(), work);
    else
        domains.share.forCells(domains.nCells(), work);
}

/// Does point p belong to the material?
template <int Dim>
bool isStressPoint(const SmoothingDomains<Dim>& domains, int p) {
    return domains.scheme == Integration::elemental || domains.around->count(p) > 0;
}

/// A cell of point p (the first around a node), for its material: bodies of different materials share no patch.
template <int Dim>
int cellOfPoint(const SmoothingDomains<Dim>& domains, int p) {
    return domains.scheme == Integration::nodal ? domains.around->cell[domains.around->start[p]] : p;
}

/// Omega of point p [m2 (2D), m3].
template <int Dim>
double pointVolume(const SmoothingDomains<Dim>& domains, int p) {
    return domains.scheme == Integration::nodal ? domains.volume[p] : domains.element[p].measure;
}

/// Mean of a nodal number over the nodes of cell e.
template <int Dim>
double cellMean(const SmoothingDomains<Dim>& domains, const PerNode<double>& nodal, int e) {
    double sum = 0;
    for (int node : domains.cell(e)) sum += nodal[node] / (Dim + 1);
    return sum;
}

/// A nodal number, such as the mesh size h, at point p.
template <int Dim>
double atPoint(const SmoothingDomains<Dim>& domains, const PerNode<double>& nodal, int p) {
    return domains.scheme == Integration::nodal ? nodal[p] : cellMean<Dim>(domains, nodal, p);
}

/// An element field at the points: its mean over each patch.
template <int Dim, class Value>
PerPoint<Value> toPoints(const SmoothingDomains<Dim>& domains, PerCell<Value> element) {
    if (domains.scheme == Integration::elemental) return PerPoint<Value>(std::move(element).values());
    return PerPoint<Value>(nodalMean<Dim>(domains, element));
}

/// The element field that has the force of a field on the points: sum_p Omega_p sigma_p G_pJ = sum_e |e| s_e grad N_J.
template <int Dim, class Value>
PerCell<Value> fromPoints(const SmoothingDomains<Dim>& domains, PerPoint<Value> point) {
    if (domains.scheme == Integration::elemental) return PerCell<Value>(std::move(point).values());
    return elementMean<Dim>(domains, point.values());
}

/// The velocity's gradient at point p.
template <int Dim>
const Tensor<Dim>& atPoint(const SmoothingDomains<Dim>& domains, const VelocityGradients<Dim>& L, int p) {
    return domains.scheme == Integration::nodal ? L.nodal[p] : L.element[p];
}

/// What is stored, as a field on the points. `cell` is empty in states of a nodal run: then the means of the nodes.
template <int Dim, class Value>
PerPoint<Value> storedAtPoints(const SmoothingDomains<Dim>& domains, const PerNode<Value>& nodal,
                               const std::vector<Value>& cell) {
    if (domains.scheme == Integration::nodal) return PerPoint<Value>(nodal);
    return PerPoint<Value>(cell.empty() ? elementMean<Dim>(domains, nodal).values() : cell);
}

/// Store a field of the points: in `cell` what elements carry (empty for nodal), in `nodal` its value at the nodes.
template <int Dim, class Value>
void storeFromPoints(const SmoothingDomains<Dim>& domains, PerPoint<Value> point, PerNode<Value>& nodal,
                     std::vector<Value>& cell) {
    if (domains.scheme == Integration::nodal) {
        nodal = std::move(point).values();
        cell.clear();
    } else {
        const PerCell<Value> element(std::move(point).values());
        nodal = nodalMean<Dim>(domains, element);
        cell = element.values();
    }
}

}  // namespace pfem
