#include "remesh/connectivity.hpp"

#include <algorithm>
#include <cmath>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "mesh/heldPoints.hpp"
#include "mesh/onFace.hpp"
#include "mesh/simplex.hpp"
#include "mesh/wallUnder.hpp"
#include "remesh/cutByWalls.hpp"

namespace pfem {

namespace {

constexpr double lens = 0.05;          // of h^2: least area of a triangle between nodes of one bent wall
constexpr double releasePlace = 0.25;  // between two places; the contact line has moved on at 0.5

/// h^Dim, in 3D so that a regular tetrahedron has the same part of it as a regular triangle has of h^2.
template <int Dim>
double sizeMeasure(double h) {
    if constexpr (Dim == 2)
        return h * h;
    else
        return std::sqrt(2.0 / 27) * h * h * h;
}

/// Height of the cell over its face opposite to local node k.
template <int Dim>
double height(const Points<Dim>& x, const Simplex<Dim>& s, int k) {
    return Dim * simplexMeasure<Dim>(x, s) / faceArea<Dim>(x, oppositeFace<Dim>(s, k)).norm();
}

template <int Dim>
double meanSize(const CandidateNodes<Dim>& nodes, const Simplex<Dim>& s) {
    double sum = 0;
    for (const int node : s) sum += nodes.h[node];
    return sum / (Dim + 1);
}

template <int Dim>
int largestFace(const Points<Dim>& x, const Simplex<Dim>& s) {
    int best = 0;
    double size = 0;
    for (int k = 0; k <= Dim; ++k) {
        const double l = faceArea<Dim>(x, oppositeFace<Dim>(s, k)).squaredNorm();
        if (l > size) {
            size = l;
            best = k;
        }
    }
    return best;
}

/// Distance of a node from the middle of those of the cell's other nodes that are on solids and wet, or dry.
template <int Dim>
double distanceToPlaces(const CandidateNodes<Dim>& nodes, const Simplex<Dim>& s, int fluidNode, bool wet) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    int count = 0;
    for (const int node : s) {
        if (!nodes.onSolid[node] || static_cast<bool>(nodes.wet[node]) != wet) continue;
        sum += nodes.x[node];
        ++count;
    }
    return (nodes.x[s[fluidNode]] - sum / count).norm();
}

/// The contact rules for a cell outside the moved old mesh.
template <int Dim>
bool isContact(const RemeshingControls& c, const CandidateNodes<Dim>& nodes, const Simplex<Dim>& s) {
    const double h = meanSize<Dim>(nodes, s);
    if (circumradius<Dim>(nodes.x, s) > c.expert.newContactRadius * h) return false;
    int held = 0, dry = 0, fluidNode = -1, dryNode = -1;
    for (int k = 0; k <= Dim; ++k) {
        if (!nodes.onSolid[s[k]]) {
            fluidNode = k;
            continue;
        }
        ++held;
        if (!nodes.wet[s[k]]) {
            ++dry;
            dryNode = k;
        }
    }
    if (held == Dim + 1) return false;
    if (held == Dim && dry > 0 && dry < Dim)  // the contact line moves on when the fluid has passed the middle
        return distanceToPlaces<Dim>(nodes, s, fluidNode, false) < distanceToPlaces<Dim>(nodes, s, fluidNode, true);
    if (simplexDivergence<Dim>(nodes.x, nodes.v, s) >= 0) return false;
    if (held == Dim) return height<Dim>(nodes.x, s, fluidNode) < c.wallContactHeight * h;
    if (dry > 0) return height<Dim>(nodes.x, s, dryNode) < c.wallContactHeight * h;
    return height<Dim>(nodes.x, s, largestFace<Dim>(nodes.x, s)) < c.contactHeight * h;
}

template <int Dim>
class Selector {
public:
    Selector(const RemeshingControls& controls, const Triangulation<Dim>& triangulation,
             const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved)
        : controls_(controls),
          t_(triangulation),
          nodes_(nodes),
          moved_(moved),
          inside_(t_.cells.size(), 0),
          accepted_(t_.cells.size(), 0),
          gap_(t_.cells.size(), 0) {}

    Connectivity<Dim> select() {
        judge();
        cutAtWalls();
        countCells();
        peel();
        result_.fluid = cellsWhere([&](int e) { return accepted_[e] != 0; });
        result_.gaps = cellsWhere([&](int e) { return gap_[e] != 0; });
        for (const int e : parallelChosen(nCells(), [&](int k) { return accepted_[k] && !inside_[k]; }))
            change(e, VolumeCause::contact, 1);
        return std::move(result_);
    }

private:
    int nCells() const { return static_cast<int>(t_.cells.size()); }

    template <class Holds>
    std::vector<Simplex<Dim>> cellsWhere(const Holds& holds) const {
        const auto found = parallelChosen(nCells(), holds);
        std::vector<Simplex<Dim>> cells(found.size());
        parallelFor(static_cast<int>(found.size()), [&](int k) { cells[k] = t_.cells[found[k]]; });
        return cells;
    }

    /// Most cells of the fluid are found among the old cells of their own nodes; of the others all centroids are looked
    /// for at once.
    void judge() {
        std::vector<unsigned char> isOpen(nCells());
        parallelFor(nCells(), [&](int e) {
            const auto& s = t_.cells[e];
            if (isFlatOnWall(s) || (isOnSolids(s) && isSliver(s))) return;
            accepted_[e] = inside_[e] = wasFluidAround(s, simplexCentroid<Dim>(nodes_.x, s));
            isOpen[e] = !inside_[e];
        });
        const auto forOpen = [&](const std::vector<Simplex<Dim>>& old, const auto& decide) {  // decide(e, in old mesh)
            const auto open = parallelChosen(nCells(), [&](int e) { return isOpen[e] != 0; });
            Points<Dim> centres;
            for (const int e : open) centres.push_back(simplexCentroid<Dim>(nodes_.x, t_.cells[e]));
            const auto held = heldPoints<Dim>(moved_.x, old, centres);
            parallelFor(static_cast<int>(open.size()), [&](int k) { decide(open[k], held[k] != 0); });
        };
        forOpen(moved_.fluid, [&](int e, bool wasFluid) {
            const auto& s = t_.cells[e];
            accepted_[e] = inside_[e] = wasFluid;
            isOpen[e] = !wasFluid && !isOnSolids(s) && !isBehindWall(s, simplexCentroid<Dim>(nodes_.x, s));
        });
        forOpen(moved_.solid, [&](int e, bool wasSolid) {
            const auto& s = t_.cells[e];
            accepted_[e] = !wasSolid && isContact<Dim>(controls_, nodes_, s);
            gap_[e] = !wasSolid && !accepted_[e] && isGap(s);
        });
    }

    /// Where fluid, two nodes in cells or drops, may soon meet fluid or a solid.
    bool isGap(const Simplex<Dim>& s) const {
        const auto fluid = std::count_if(s.begin(), s.end(), [&](int node) { return !nodes_.onSolid[node]; });
        return fluid >= 2 &&
               circumradius<Dim>(nodes_.x, s) < controls_.expert.newContactRadius * meanSize<Dim>(nodes_, s);
    }

    /// The old cell with the same nodes, or -1.
    int oldCell(const Simplex<Dim>& s) const {
        const NodeToCells& around = moved_.topology.fluid;
        const int first = nodes_.old[s[0]];
        if (first < 0) return -1;
        for (int slot = around.start[first]; slot < around.start[first + 1]; ++slot) {
            const Simplex<Dim>& cell = moved_.fluid[around.cell[slot]];
            const auto has = [&](int node) {
                return std::find(cell.begin(), cell.end(), nodes_.old[node]) != cell.end();
            };
            if (std::all_of(s.begin() + 1, s.end(), has)) return around.cell[slot];
        }
        return -1;
    }

    /// Do the old cells of its nodes hold the point? Mostly the same cell does.
    bool wasFluidAround(const Simplex<Dim>& s, const Vec<Dim>& centre) const {
        const NodeToCells& around = moved_.topology.fluid;
        const int same = oldCell(s);
        if (same >= 0 && holds<Dim>(moved_.x, moved_.fluid[same], centre)) return true;
        for (int node : s) {
            const int old = nodes_.old[node];
            if (old < 0) continue;
            for (int slot = around.start[old]; slot < around.start[old + 1]; ++slot)
                if (holds<Dim>(moved_.x, moved_.fluid[around.cell[slot]], centre)) return true;
        }
        return false;
    }

    bool isOnWall(int node) const { return isSupported(nodes_.wall[node]); }

    /// Three nodes of one wall are on one line, up to round-off and the bends of the wall: what is between them is no
    /// fluid.
    bool isFlatOnWall(const Simplex<Dim>& s) const {
        const double h = meanSize<Dim>(nodes_, s);
        if (std::any_of(s.begin(), s.end(), [&](int node) { return !isBound(node); })) return false;
        if (simplexMeasure<Dim>(nodes_.x, s) < 1e-9 * std::pow(h, Dim))
            return std::any_of(s.begin(), s.end(), [&](int node) { return isOnWall(node); });
        return simplexMeasure<Dim>(nodes_.x, s) < lens * sizeMeasure<Dim>(h) && onOneWall(s);
    }

    /// On the wrong side of a wall that one of its nodes slides along, where the wall is.
    bool isBehindWall(const Simplex<Dim>& s, const Vec<Dim>& centre) const {
        for (const int node : s)
            for (const int wall : nodes_.wall[node]) {
                if (wall < 0) continue;
                const auto place = placeOnRegion<Dim>(moved_.topology.walls, moved_.x, wall, centre);
                const Vec<Dim> inward = inwardNormal<Dim>(moved_.x, moved_.topology.walls[place.face].nodes);
                if (place.beyond < 0 && inward.dot(centre - place.x) < 0) return true;
            }
        return false;
    }

    /// What has come round the end of a wall is not joined through it with what is before it.
    void cutAtWalls() {
        const auto asked = [&](int e) { return accepted_[e] || gap_[e]; };
        for (const int e : cutByWalls<Dim>(nodes_, moved_, t_, parallelChosen(nCells(), asked))) {
            if (accepted_[e] && inside_[e]) change(e, VolumeCause::released, -1);
            accepted_[e] = gap_[e] = 0;
        }
    }

    void countCells() {
        cells_.assign(nodes_.x.size(), 0);
        for (std::size_t e = 0; e < t_.cells.size(); ++e)
            if (accepted_[e])
                for (int node : t_.cells[e]) ++cells_[node];
    }

    bool isFluid(int e) const { return e >= 0 && accepted_[e]; }

    bool isBound(int node) const { return nodes_.onSolid[node] || isOnWall(node); }

    template <std::size_t N>
    bool isOnSolids(const std::array<int, N>& nodes) const {
        return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return nodes_.onSolid[node]; });
    }

    /// Have all nodes a support that is joined with one of the first's?
    template <std::size_t N>
    bool onOneWall(const std::array<int, N>& nodes) const {
        const auto lies = [&](int node, int wall) {
            const auto& own = nodes_.wall[node];
            return std::any_of(own.begin(), own.end(),
                               [&](int other) { return other >= 0 && moved_.topology.joined(wall, other); });
        };
        const auto& first = nodes_.wall[nodes[0]];
        return std::any_of(first.begin(), first.end(), [&](int wall) {
            return wall >= 0 && std::all_of(nodes.begin(), nodes.end(), [&](int node) { return lies(node, wall); });
        });
    }

    /// Does the face lie on a solid, or on one wall and has its normal?
    bool isClosed(const Face<Dim>& face) const {
        if (isOnSolids(face)) return true;
        if (!isOnWall(face[0])) return false;
        const Vec<Dim> outward = faceArea<Dim>(nodes_.x, face).normalized();
        const auto supports = [&](int node) -> const Supports<Dim>& { return nodes_.wall[node]; };
        return wallUnder<Dim>(moved_.topology, moved_.x, face, outward, supports) >= 0;
    }

    /// A face of the cell is open to the air.
    bool isAtSurface(int e) const {
        for (int k = 0; k <= Dim; ++k)
            if (!isFluid(t_.neighbours[e][k]) && !isClosed(oppositeFace<Dim>(t_.cells[e], k))) return true;
        return false;
    }

    bool isSliver(const Simplex<Dim>& s) const {
        return simplexMeasure<Dim>(nodes_.x, s) < controls_.expert.sliver * sizeMeasure<Dim>(meanSize<Dim>(nodes_, s));
    }

    bool isStretched(int e) const {
        const auto& s = t_.cells[e];
        return isSliver(s) || circumradius<Dim>(nodes_.x, s) >
                                  controls_.expert.alpha * controls_.expert.alphaInside * meanSize<Dim>(nodes_, s);
    }

    /// A lone triangle between places of solids: what little it holds, no fluid node can carry.
    bool isTrapped(int e) const {
        const auto& n = t_.neighbours[e];
        return isOnSolids(t_.cells[e]) && std::none_of(n.begin(), n.end(), [&](int other) { return isFluid(other); });
    }

    /// A node hangs on this triangle alone, and the triangle is flat or about to collapse: such a node has hardly any
    /// mass and pressure cannot hold it.
    bool isCarriedByOne(int e) const {
        const auto& s = t_.cells[e];
        if (std::none_of(s.begin(), s.end(), [&](int node) { return cells_[node] == 1 && !nodes_.onSolid[node]; }))
            return false;
        const double least = controls_.expert.hangingArea * sizeMeasure<Dim>(meanSize<Dim>(nodes_, s));
        return simplexMeasure<Dim>(nodes_.x, s) < least ||
               simplexDivergence<Dim>(nodes_.x, nodes_.v, s) * nodes_.dt < -0.5;
    }

    /// A place on a solid that only this triangle carries, and the fluid has gone back to a quarter of the way to the
    /// other place: well behind the middle where it has come to it, for the volume of the triangle comes and goes with
    /// it, and the level with that.
    bool isReleased(int e) const {
        const auto& s = t_.cells[e];
        for (int k = 0; k <= Dim; ++k) {
            const auto face = oppositeFace<Dim>(s, k);
            if (nodes_.onSolid[s[k]] || !isOnSolids(face)) continue;
            const auto weight = footWeights<Dim>(nodes_.x, face, nodes_.x[s[k]]);
            for (int i = 0; i < Dim; ++i)
                if (cells_[face[i]] == 1 && weight[i] < releasePlace) return true;
            return false;
        }
        return false;
    }

    void change(std::size_t e, VolumeCause cause, int sign) {
        result_.changes.push_back({cause, t_.cells[e], sign * simplexMeasure<Dim>(nodes_.x, t_.cells[e])});
    }

    void peel() {
        std::vector<int> work = parallelChosen(nCells(), [&](int e) {  // others come when a neighbour has gone
            return accepted_[e] && (isAtSurface(e) || isTrapped(e));
        });
        while (!work.empty()) {
            const int e = work.back();
            work.pop_back();
            if (!accepted_[e] || !(isAtSurface(e) || isTrapped(e))) continue;
            const bool stretched = isStretched(e) || isCarriedByOne(e);
            if (!stretched && !isTrapped(e) && !isReleased(e)) continue;
            accepted_[e] = 0;
            if (inside_[e]) change(e, stretched ? VolumeCause::stretched : VolumeCause::released, -1);
            for (int node : t_.cells[e]) --cells_[node];
            for (int other : t_.neighbours[e])
                if (isFluid(other)) work.push_back(other);
        }
    }

    const RemeshingControls& controls_;
    const Triangulation<Dim>& t_;
    const CandidateNodes<Dim>& nodes_;
    const MovedMesh<Dim>& moved_;
    std::vector<unsigned char> inside_;
    std::vector<unsigned char> accepted_;
    std::vector<unsigned char> gap_;
    std::vector<int> cells_;  // accepted cells per node
    Connectivity<Dim> result_;
};

}  // namespace

template <int Dim>
std::vector<Simplex<Dim>> cellsOf(const std::vector<CellChange<Dim>>& changes, VolumeCause cause) {
    std::vector<Simplex<Dim>> cells;
    for (const auto& change : changes)
        if (change.cause == cause) cells.push_back(change.cell);
    return cells;
}

template <int Dim>
Connectivity<Dim> selectFluid(const RemeshingControls& controls, const Triangulation<Dim>& triangulation,
                              const CandidateNodes<Dim>& nodes, const MovedMesh<Dim>& moved) {
    return Selector<Dim>(controls, triangulation, nodes, moved).select();
}

#define PFEM_INSTANTIATE(D)                                                                      \
    template std::vector<Simplex<D>> cellsOf<D>(const std::vector<CellChange<D>>&, VolumeCause); \
    template Connectivity<D> selectFluid<D>(const RemeshingControls&, const Triangulation<D>&,   \
                                            const CandidateNodes<D>&, const MovedMesh<D>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
