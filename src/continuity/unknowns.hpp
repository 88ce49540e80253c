#pragma once
// Which unknowns the coupled matrix of pressures and velocities has.

#include <tuple>
#include <utility>
#include <vector>

#include "momentum/solidMatrix.hpp"
#include "momentum/step.hpp"
#include "parallel/share.hpp"

namespace pfem {

/// Numbering of the coupled matrix: pressures, solid velocities, velocities of nodes at the free surface and at
/// outlets.
struct Unknowns {
    std::vector<unsigned char> isMade;  // per node: is the column of its pressure?
    std::vector<int> pressure;          // per node: its pressure unknown or -1
    std::vector<int> surface;           // per node: first velocity unknown of a moving free-surface node or -1
    int nPressure = 0;
    int nSolid = 0;
    int n = 0;
};

template <int Dim>
Unknowns numberUnknowns(const Step<Dim>& step, const Share& share, bool strong, int nSolid) {
    const auto& [topology, constraints] = std::tie(step.topology, step.constraints);
    Unknowns u;
    u.pressure.assign(topology.nNodes(), -1);
    u.surface.assign(topology.nNodes(), -1);
    u.nSolid = nSolid;
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.wet(i) && !step.isImage(i) && !(strong && topology.freeSurface[i])) u.pressure[i] = u.nPressure++;
    step.follow(u.pressure);
    u.isMade.assign(topology.nNodes(), share.isWhole());
    if (!share.isWhole())  // all that own rows have in common with others by velocities
        for (const int e : share.cells())
            for (const int i : step.mesh.fluid.nodes[e]) u.isMade[i] = 1;
    for (int i = 0; i < topology.nNodes(); ++i)
        if (u.pressure[i] < 0 || step.isImage(i)) u.isMade[i] = 0;
    u.n = u.nPressure + nSolid;
    if (strong) return u;
    for (int i = 0; i < topology.nNodes(); ++i) {
        if (!topology.freeSurface[i] && !(topology.wet(i) && topology.onOpening(i))) continue;
        if (topology.onSolid[i] || step.isImage(i) || !constraints.freedom[i].any()) continue;
        u.surface[i] = u.n;
        u.n += Dim;
    }
    step.follow(u.surface);
    return u;
}

template <int Dim>
int nVelocities(const Unknowns& u, const SolidDofs<Dim>& solid, int node) {
    return solid.local[node] >= 0 ? solid.count[node] : u.surface[node] >= 0 ? Dim : 0;
}

/// Visit the velocity unknowns of a node: visit(unknown, direction).
template <int Dim, class Visitor>
void forVelocities(const Unknowns& u, const SolidDofs<Dim>& solid, int node, Visitor&& visit) {
    if (solid.local[node] >= 0)
        for (int c = 0; c < solid.count[node]; ++c)
            visit(u.nPressure + solid.first[node] + c, Vec<Dim>(solid.basis[solid.local[node]].col(c)));
    else if (u.surface[node] >= 0)
        for (int c = 0; c < Dim; ++c) visit(u.surface[node] + c, Vec<Dim>(Vec<Dim>::Unit(c)));
}

}  // namespace pfem
