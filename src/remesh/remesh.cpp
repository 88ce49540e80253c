#include "remesh/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"
#include "mesh/wallUnder.hpp"
#include "remesh/connectivity.hpp"
#include "remesh/fixedFaces.hpp"
#include "remesh/heirs.hpp"
#include "remesh/joinDrops.hpp"
#include "remesh/keepMomentum.hpp"
#include "remesh/lostVolume.hpp"
#include "remesh/newPlaces.hpp"
#include "remesh/nodeControl.hpp"
#include "remesh/passOn.hpp"

namespace pfem {

namespace {

/// The wall faces that hold an edge of the fluid's boundary, or of its inside (none).
template <int Dim>
Supports<Dim> supportsOf(const Topology<Dim>& topology, const Points<Dim>& x, std::array<int, 2> edge) {
    Supports<Dim> supports = unsupported<Dim>();
    const auto hold = [&](int wall) {
        if (!isOnRegion<Dim>(topology.walls, supports, topology.walls[wall].region)) addSupport(supports, wall);
    };
    for (const auto& face : topology.faces) {
        if (face.wall < 0) continue;
        const auto has = [&](int node) {
            return std::find(face.nodes.begin(), face.nodes.end(), node) != face.nodes.end();
        };
        if (!has(edge[0]) || !has(edge[1])) continue;
        hold(face.wall);
        const auto common = commonWalls<Dim>(topology, face.nodes);
        if (!isAlongEdge<Dim>(x, face.nodes, common)) continue;
        for (const int wall : common)
            if (wall >= 0) hold(wall);
    }
    return supports;
}

/// Where a point of an edge belongs that lies on a wall, perhaps with one end round a convex edge of it: on the nearer
/// one, for beyond the other's end another node may be.
template <int Dim>
WallPlace<Dim> placeBeside(const Topology<Dim>& topology, const Points<Dim>& x, std::array<int, 2> edge, int wall,
                           const Vec<Dim>& point) {
    auto place = placeOnRegion<Dim>(topology.walls, x, wall, point);
    for (const int end : edge)
        for (const int other : topology.supports[end]) {
            if (other < 0 || !topology.joined(wall, other)) continue;
            const auto there = placeOnRegion<Dim>(topology.walls, x, other, point);
            if ((there.x - point).norm() < (place.x - point).norm()) place = there;
        }
    return place;
}

/// Midpoint of an edge with the mean of its ends; on a wall when the edge lies on it.
template <int Dim>
void insertNode(const Nodes<Dim>& old, int i, int j, const Topology<Dim>& topology, State<Dim>& state) {
    Nodes<Dim>& nodes = state.nodes;
    nodes.appendBetween(old, i, j);
    nodes.id.back() = state.nextId++;
    nodes.wall.back() = supportsOf<Dim>(topology, old.x, {i, j});
    for (int& wall : nodes.wall.back()) {
        if (wall < 0) continue;
        const auto place = placeBeside<Dim>(topology, old.x, {i, j}, wall, nodes.x.back());
        wall = place.face;
        nodes.x.back() = place.x;
    }
    nodes.X.back() = nodes.x.back();
}

/// Carry the plan out; returns the new index of each old node (-1 removed), inserted nodes after them.
template <int Dim>
std::vector<int> carryOut(const NodePlan<Dim>& plan, const MovedMesh<Dim>& moved, State<Dim>& state) {
    if (plan.inserted.empty() && std::count(plan.removed.begin(), plan.removed.end(), 1) == 0) {
        std::vector<int> same(state.nodes.size());
        std::iota(same.begin(), same.end(), 0);
        return same;
    }
    const Nodes<Dim> old = std::move(state.nodes);
    std::vector<int> newIndex(old.size() + plan.inserted.size(), -1), stay;
    stay.reserve(old.size());
    for (int i = 0; i < old.size(); ++i) {
        if (plan.removed[i]) continue;
        newIndex[i] = static_cast<int>(stay.size());
        stay.push_back(i);
    }
    state.nodes = old.taken(stay);
    for (std::size_t k = 0; k < plan.inserted.size(); ++k) {
        newIndex[old.size() + k] = state.nodes.size();
        const auto [a, b] = plan.inserted[k];
        insertNode(old, a, b, moved.topology, state);
    }
    for (auto& s : state.mesh.solid.nodes)
        for (int& node : s) node = newIndex[node];
    for (auto& patch : state.mesh.patches)
        for (auto& face : patch.faces)
            for (int& node : face) node = newIndex[node];
    return newIndex;
}

/// Nodes that have left through periodic sides come in again, and the bands beyond are filled with their images.
template <int Dim>
NewPlaces<Dim> throughSides(const Sides<Dim>* sides, const MovedMesh<Dim>& moved, std::vector<int>& newIndex,
                            State<Dim>& state) {
    if (!sides) return {moved.images, newIndex, {}, {}};
    moved.images.follow(newIndex);
    state.mesh.fluid.nodes.clear();
    auto back = comeBack<Dim>(*sides, state);
    setImages<Dim>(*sides, state);
    return {moved.images, newIndex, std::move(back), imagesOf<Dim>(state)};
}

template <int Dim>
std::vector<Face<Dim>> surfaceFaces(const RemeshingControls& controls, const NodePlan<Dim>& plan,
                                    const Sides<Dim>* sides, const NewPlaces<Dim>& places) {
    if (!controls.keepSurface) return {};
    std::vector<Face<Dim>> surface;
    const auto add = [&](const Shift<Dim>& shift) {
        for (Face<Dim> face : plan.surface) {
            for (int& node : face) node = places.at(node, shift);
            if (std::none_of(face.begin(), face.end(), [](int node) { return node < 0; })) surface.push_back(face);
        }
    };
    add({});
    if (sides)
        for (const auto& shift : shiftsOf<Dim>(sides->period)) add(shift);
    return surface;
}

/// What the selection rules ask about the new nodes.
template <int Dim>
CandidateNodes<Dim> candidateNodes(const State<Dim>& state, const MovedMesh<Dim>& moved, const NewPlaces<Dim>& places,
                                   double dt) {
    CandidateNodes<Dim> c;
    c.dt = dt;
    const int n = state.nodes.size();
    c.x = state.nodes.x;
    c.v = state.nodes.v;
    c.h = state.nodes.h;
    c.onSolid.assign(n, 0);
    c.wet.assign(n, 1);  // inserted nodes are inside the fluid
    c.wall = state.nodes.wall;
    c.old.assign(n, -1);
    for (int i = 0; i < moved.topology.nNodes(); ++i) {
        const int now = places.at(i);
        if (now < 0) continue;
        c.old[now] = i;
        c.onSolid[now] = moved.topology.onSolid[i];
        if (moved.topology.onSolid[i]) c.wall[now] = moved.topology.supports[i];
        c.wet[now] = moved.topology.wet(i);
    }
    places.follow(c.wet);
    return c;
}

/// Solid nodes off the boundary or under a skin, and points of walls, do not take part in the triangulation.
template <int Dim>
std::vector<int> activeNodes(const State<Dim>& state, const std::vector<PatchKind>& kinds,
                             const Topology<Dim>& topology, const std::vector<int>& newIndex) {
    const auto around = nodeToCells<Dim>(state.mesh.solid.nodes, state.nodes.size());
    std::vector<unsigned char> active(state.nodes.size(), 1);
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (const auto& face : state.mesh.patches[k].faces)
            for (int node : face) active[node] = !isWall(kinds[k]);
    for (const auto& s : state.mesh.solid.nodes)
        for (int node : s) active[node] = 0;
    for (const auto& face : boundaryFaces<Dim>(state.mesh.solid.nodes, around))
        for (int node : face.nodes) active[node] = 1;
    for (int i = 0; i < topology.nNodes(); ++i)
        if (topology.isUnderSkin(i)) active[newIndex[i]] = 0;
    std::vector<int> list;
    for (int i = 0; i < state.nodes.size(); ++i)
        if (active[i]) list.push_back(i);
    return list;
}

/// Drops that go take their volume with them.
template <int Dim>
void bookGone(const MovedMesh<Dim>& moved, const std::vector<int>& gone, State<Dim>& state) {
    if (gone.empty()) return;
    std::vector<double> amounts = moved.gone;
    for (double& amount : amounts) amount = -amount;
    state.ledger.book(VolumeCause::gone, amounts);
}

/// Of cells and their copies beyond periodic sides those that count.
template <int Dim>
void keepOwn(const State<Dim>& state, Connectivity<Dim>& selected) {
    const auto isCopy = [&](const Simplex<Dim>& cell) { return !isOwn(state.nodes.id, cell); };
    auto& [fluid, gaps, changes] = selected;
    fluid.erase(std::remove_if(fluid.begin(), fluid.end(), isCopy), fluid.end());
    gaps.erase(std::remove_if(gaps.begin(), gaps.end(), isCopy), gaps.end());
    changes.erase(std::remove_if(changes.begin(), changes.end(), [&](const auto& c) { return isCopy(c.cell); }),
                  changes.end());
}

/// The changes with masters in the place of their images.
template <int Dim>
std::vector<CellChange<Dim>> ofMasters(const Images<Dim>& images, std::vector<CellChange<Dim>> changes) {
    for (auto& change : changes)
        for (int& node : change.cell) node = images.own(node);
    return changes;
}

/// Nodes without triangles have no pressure.
template <int Dim>
void clearDryPressure(State<Dim>& state) {
    const auto wet = nodesIn<Dim>(state.mesh.fluid.nodes, state.nodes.size());
    for (int i = 0; i < state.nodes.size(); ++i)
        if (!wet[i]) state.nodes.p[i] = 0;
}

}  // namespace

template <int Dim>
bool isDistorted(double distortion, const Points<Dim>& x, const std::vector<Simplex<Dim>>& fluid) {
    return distortion == 0 || std::any_of(fluid.begin(), fluid.end(), [&](const Simplex<Dim>& s) {
               double squares = 0;
               for (int a = 0; a < Dim; ++a)
                   for (int b = a + 1; b <= Dim; ++b) squares += (x[s[b]] - x[s[a]]).squaredNorm();
               const double measure = simplexMeasure<Dim>(x, s);
               if constexpr (Dim == 2)
                   return 4 * std::sqrt(3.0) * measure < distortion * squares;
               else
                   return 12 * std::cbrt(9 * measure * std::abs(measure)) < distortion * squares;
           });
}

template <int Dim>
RemeshReport<Dim> remesh(RemeshTask<Dim> task, Triangulator<Dim>& triangulator, State<Dim>& state) {
    const RemeshingControls& controls = task.controls;
    const std::vector<PatchKind>& kinds = task.kinds;
    MovedMesh<Dim> moved = movedMesh<Dim>(state, std::move(task.topology), task.gone);
    joinDrops<Dim>(controls, moved, state);
    const Points<Dim> vOld = controls.keepMomentum ? state.nodes.v : Points<Dim>();
    const int nOldCells = nOwnCells<Dim>(state);
    for (const int drop : squeezeDrops<Dim>(task.pinched, moved)) task.gone.push_back(drop);
    const double drops = std::accumulate(moved.dropVolume.begin(), moved.dropVolume.end(), 0.0);
    bookGone<Dim>(moved, task.gone, state);
    auto kept = keptNodes<Dim>(state.mesh, state.nodes.size());
    for (const int lip : task.lips)
        if (!kept[lip]) kept[lip] = keptAtLip;
    auto plan = planNodes<Dim>(controls, moved, state.nodes.h, kept, task.pinched);
    for (const int drop : task.gone) plan.removed[drop] = 1;
    std::fill(plan.removed.begin() + moved.images.nOwn, plan.removed.end(), 1);  // images are made anew
    for (std::size_t i = 0; i < moved.joins.size(); ++i)
        if (moved.joins[i] >= 0) plan.removed[i] = 1;
    const int material = state.mesh.fluid.material.empty() ? 0 : state.mesh.fluid.material[0];
    auto newIndex = carryOut<Dim>(plan, moved, state);
    const auto newPlaces = throughSides<Dim>(task.sides, moved, newIndex, state);

    CandidateNodes<Dim> candidates;
    const auto triangulate = [&] {
        triangulator.follow(state.nodes.x, state.nodes.id, activeNodes<Dim>(state, kinds, moved.topology, newIndex),
                            fixedFaces<Dim>(state, kinds, moved.topology, newIndex),
                            surfaceFaces<Dim>(controls, plan, task.sides, newPlaces));
    };
    const auto ask = [&] { candidates = candidateNodes<Dim>(state, moved, newPlaces, task.dt); };
    if (Dim == 2) {
        parallelInvoke(state.nodes.size(), triangulate, ask);
    } else {  // by threads of its own
        triangulate();
        ask();
    }
    auto selected = selectFluid<Dim>(controls, triangulator.triangulation(state.nodes.size()), candidates, moved);
    if (task.sides) keepOwn<Dim>(state, selected);
    state.mesh.fluid.nodes = selected.fluid;
    state.mesh.fluid.material.assign(selected.fluid.size(), material);
    Points<Dim> missing;
    if (controls.keepMomentum)
        missing = missingVelocity<Dim>(moved, vOld, nOldCells, newIndex, selected.changes, state);
    if (task.sides) setCopies<Dim>(*task.sides, state);
    moved.images.hide(moved.topology.freeSurface);  // what is changed there is changed at the masters

    VolumeLedger sheet = state.ledger.sheet(state.nodes.size());
    bookRemeshing<Dim>(moved, plan, newIndex, ofMasters<Dim>(imagesOf<Dim>(state), selected.changes), sheet, state);
    sheet.book(VolumeCause::isolated, dropVolume<Dim>(state) - drops);
    sheet.place(VolumeCause::isolated, state.nodes.dropVolume);
    state.ledger.place(VolumeCause::isolated, moved.dropVolume, -1);
    postRemeshing<Dim>(moved, newIndex, std::move(sheet), state);
    clearDryPressure<Dim>(state);

    RemeshReport<Dim> report;
    report.removed = std::accumulate(plan.removed.begin(), plan.removed.begin() + moved.images.nOwn, 0);
    report.inserted = static_cast<int>(plan.inserted.size());
    report.contacts = cellsOf<Dim>(selected.changes, VolumeCause::contact);
    report.gaps = selected.gaps;
    report.missing = std::move(missing);
    return report;
}

#define PFEM_INSTANTIATE(D)                                                                 \
    template bool isDistorted<D>(double, const Points<D>&, const std::vector<Simplex<D>>&); \
    template RemeshReport<D> remesh<D>(RemeshTask<D>, Triangulator<D>&, State<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
