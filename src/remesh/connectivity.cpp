#include "remesh/connectivity.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

constexpr double lens = 0.05;          // of h^2: least area of a triangle between nodes of one bent wall
constexpr double releasePlace = 0.25;  // between two places; the contact line has moved on at 0.5

/// Height of the triangle over its face opposite to local node k.
double height(const Points<2>& x, const Simplex<2>& s, int k) {
    return 2 * simplexMeasure<2>(x, s) / faceArea<2>(x, oppositeFace<2>(s, k)).norm();
}

double meanSize(const CandidateNodes& nodes, const Simplex<2>& s) {
    return (nodes.h[s[0]] + nodes.h[s[1]] + nodes.h[s[2]]) / 3;
}

int longestFace(const Points<2>& x, const Simplex<2>& s) {
    int best = 0;
    double length = 0;
    for (int k = 0; k < 3; ++k) {
        const double l = faceArea<2>(x, oppositeFace<2>(s, k)).squaredNorm();
        if (l > length) {
            length = l;
            best = k;
        }
    }
    return best;
}

/// The contact rules for a triangle outside the moved old mesh.
bool isContact(const RemeshingControls& c, const CandidateNodes& nodes, const Simplex<2>& s) {
    const double h = meanSize(nodes, s);
    if (circumradius(nodes.x, s) > c.newContactRadius * h) return false;
    int held = 0, dry = 0, fluidNode = -1, dryNode = -1;
    for (int k = 0; k < 3; ++k) {
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
    if (held == 3) return false;
    if (held == 2 && dry == 1) {  // the contact line moves on when the fluid has passed the middle
        const int wetNode = 3 - fluidNode - dryNode;
        return (nodes.x[s[fluidNode]] - nodes.x[s[dryNode]]).norm() <
               (nodes.x[s[fluidNode]] - nodes.x[s[wetNode]]).norm();
    }
    if (simplexDivergence<2>(nodes.x, nodes.v, s) >= 0) return false;
    if (held == 2) return height(nodes.x, s, fluidNode) < c.wallContactHeight * h;
    if (dry == 1) return height(nodes.x, s, dryNode) < c.wallContactHeight * h;
    return height(nodes.x, s, longestFace(nodes.x, s)) < c.contactHeight * h;
}

class Selector {
public:
    Selector(const RemeshingControls& controls, const Triangulation<2>& triangulation, const CandidateNodes& nodes,
             const MovedMesh<2>& moved, const MovedPlaces& places)
        : controls_(controls),
          t_(triangulation),
          nodes_(nodes),
          moved_(moved),
          places_(places),
          inside_(t_.cells.size(), 0),
          accepted_(t_.cells.size(), 0),
          gap_(t_.cells.size(), 0) {}

    Connectivity select() {
#pragma omp parallel for schedule(static) if (static_cast <int>(t_.cells.size()) > shortLoop)
        for (int e = 0; e < static_cast<int>(t_.cells.size()); ++e) judge(e);
        countCells();
        Connectivity& result = result_;
        peel();
        result.fluid.reserve(t_.cells.size());
        for (std::size_t e = 0; e < t_.cells.size(); ++e) {
            if (gap_[e]) result.gaps.push_back(t_.cells[e]);
            if (!accepted_[e]) continue;
            result.fluid.push_back(t_.cells[e]);
            if (inside_[e]) continue;
            change(e, VolumeCause::contact, 1);
        }
        return std::move(result);
    }

private:
    void judge(int e) {
        const auto& s = t_.cells[e];
        const bool allHeld = nodes_.onSolid[s[0]] && nodes_.onSolid[s[1]] && nodes_.onSolid[s[2]];
        if (isFlatOnWall(s) || (allHeld && isSliver(s))) return;
        const Vec<2> centre = simplexCentroid<2>(nodes_.x, s);
        inside_[e] = wasFluid(s, centre);
        if (inside_[e]) {
            accepted_[e] = 1;
            return;
        }
        if (allHeld || isBehindWall(s, centre) || places_.solid.contains(centre)) return;
        accepted_[e] = isContact(controls_, nodes_, s);
        gap_[e] = !accepted_[e] && isGap(s);
    }

    /// Where fluid, two nodes in cells or drops, may soon meet fluid or a solid.
    bool isGap(const Simplex<2>& s) const {
        const auto fluid = std::count_if(s.begin(), s.end(), [&](int node) { return !nodes_.onSolid[node]; });
        return fluid >= 2 && circumradius(nodes_.x, s) < controls_.newContactRadius * meanSize(nodes_, s);
    }

    /// Does the moved old mesh hold the point? Mostly in a cell of one of the triangle's own nodes.
    bool wasFluid(const Simplex<2>& s, const Vec<2>& centre) const {
        const NodeToCells& around = moved_.topology.fluid;
        for (int node : s) {
            const int old = nodes_.old[node];
            if (old < 0) continue;
            for (int slot = around.start[old]; slot < around.start[old + 1]; ++slot)
                if (holds<2>(moved_.x, moved_.fluid[around.cell[slot]], centre)) return true;
        }
        return places_.fluid.contains(centre);
    }

    bool isOnWall(int node) const { return isSupported(nodes_.wall[node]); }

    /// Three nodes of one wall are on one line, up to round-off and the bends of the wall: what is between them is no
    /// fluid.
    bool isFlatOnWall(const Simplex<2>& s) const {
        const double h = meanSize(nodes_, s);
        if (!(isBound(s[0]) && isBound(s[1]) && isBound(s[2]))) return false;
        if (simplexMeasure<2>(nodes_.x, s) < 1e-9 * h * h)
            return std::any_of(s.begin(), s.end(), [&](int node) { return isOnWall(node); });
        return simplexMeasure<2>(nodes_.x, s) < lens * h * h && onOneWall({s[0], s[1]}) && onOneWall({s[1], s[2]}) &&
               onOneWall({s[2], s[0]});
    }

    /// On the wrong side of a wall that one of its nodes slides along, where the wall is.
    bool isBehindWall(const Simplex<2>& s, const Vec<2>& centre) const {
        for (const int node : s)
            for (const int wall : nodes_.wall[node]) {
                if (wall < 0) continue;
                const auto place = placeOnRegion<2>(moved_.topology.walls, moved_.x, wall, centre);
                const Vec<2> inward = inwardNormal<2>(moved_.x, moved_.topology.walls[place.face].nodes);
                if (place.beyond < 0 && inward.dot(centre - place.x) < 0) return true;
            }
        return false;
    }

    void countCells() {
        cells_.assign(nodes_.x.size(), 0);
        for (std::size_t e = 0; e < t_.cells.size(); ++e)
            if (accepted_[e])
                for (int node : t_.cells[e]) ++cells_[node];
    }

    bool isFluid(int e) const { return e >= 0 && accepted_[e]; }

    bool isBound(int node) const { return nodes_.onSolid[node] || isOnWall(node); }

    bool onOneWall(const Face<2>& face) const {
        for (const int wall : nodes_.wall[face[0]])
            for (const int other : nodes_.wall[face[1]])
                if (wall >= 0 && other >= 0 && moved_.topology.joined(wall, other)) return true;
        return false;
    }

    /// Does the face lie on a solid, or on one wall?
    bool isClosed(const Face<2>& face) const {
        return (nodes_.onSolid[face[0]] && nodes_.onSolid[face[1]]) || onOneWall(face);
    }

    /// A face of the cell is open to the air.
    bool isAtSurface(int e) const {
        for (int k = 0; k < 3; ++k)
            if (!isFluid(t_.neighbours[e][k]) && !isClosed(oppositeFace<2>(t_.cells[e], k))) return true;
        return false;
    }

    bool isSliver(const Simplex<2>& s) const {
        const double h = meanSize(nodes_, s);
        return simplexMeasure<2>(nodes_.x, s) < controls_.sliver * h * h;
    }

    bool isStretched(int e) const {
        const auto& s = t_.cells[e];
        return isSliver(s) || circumradius(nodes_.x, s) > controls_.alpha * controls_.alphaInside * meanSize(nodes_, s);
    }

    /// A lone triangle between places of solids: what little it holds, no fluid node can carry.
    bool isTrapped(int e) const {
        const auto& s = t_.cells[e];
        const auto& n = t_.neighbours[e];
        return nodes_.onSolid[s[0]] && nodes_.onSolid[s[1]] && nodes_.onSolid[s[2]] && !isFluid(n[0]) &&
               !isFluid(n[1]) && !isFluid(n[2]);
    }

    /// A node hangs on this triangle alone, and the triangle is flat or about to collapse: such a node has hardly any
    /// mass and pressure cannot hold it.
    bool isCarriedByOne(int e) const {
        const auto& s = t_.cells[e];
        if (std::none_of(s.begin(), s.end(), [&](int node) { return cells_[node] == 1 && !nodes_.onSolid[node]; }))
            return false;
        const double h = meanSize(nodes_, s);
        return simplexMeasure<2>(nodes_.x, s) < controls_.hangingArea * h * h ||
               simplexDivergence<2>(nodes_.x, nodes_.v, s) * nodes_.dt < -0.5;
    }

    /// A place on a solid that only this triangle carries, and the fluid has gone back to a quarter of the way to the
    /// other place: well behind the middle where it has come to it, for the volume of the triangle comes and goes with
    /// it, and the level with that.
    bool isReleased(int e) const {
        const auto& s = t_.cells[e];
        for (int k = 0; k < 3; ++k) {
            const int f = s[k], a = s[(k + 1) % 3], b = s[(k + 2) % 3];
            if (nodes_.onSolid[f] || !nodes_.onSolid[a] || !nodes_.onSolid[b]) continue;
            const Vec<2> edge = nodes_.x[b] - nodes_.x[a];
            const double place = edge.dot(nodes_.x[f] - nodes_.x[a]) / edge.squaredNorm();
            return (cells_[a] == 1 && place > 1 - releasePlace) || (cells_[b] == 1 && place < releasePlace);
        }
        return false;
    }

    void change(std::size_t e, VolumeCause cause, int sign) {
        result_.changes.push_back({cause, t_.cells[e], sign * simplexMeasure<2>(nodes_.x, t_.cells[e])});
    }

    void peel() {
        const int n = static_cast<int>(t_.cells.size());
        std::vector<unsigned char> isOpen(n);  // the others come when a neighbour has gone
        parallelFor(n, [&](int e) { isOpen[e] = accepted_[e] && (isAtSurface(e) || isTrapped(e)); });
        std::vector<int> work;
        for (int e = 0; e < n; ++e)
            if (isOpen[e]) work.push_back(e);
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
    const Triangulation<2>& t_;
    const CandidateNodes& nodes_;
    const MovedMesh<2>& moved_;
    const MovedPlaces& places_;
    std::vector<unsigned char> inside_;
    std::vector<unsigned char> accepted_;
    std::vector<unsigned char> gap_;
    std::vector<int> cells_;  // accepted cells per node
    Connectivity result_;
};

}  // namespace

std::vector<Simplex<2>> cellsOf(const std::vector<CellChange>& changes, VolumeCause cause) {
    std::vector<Simplex<2>> cells;
    for (const auto& change : changes)
        if (change.cause == cause) cells.push_back(change.cell);
    return cells;
}

Connectivity selectFluid(const RemeshingControls& controls, const Triangulation<2>& triangulation,
                         const CandidateNodes& nodes, const MovedMesh<2>& moved, const MovedPlaces& places) {
    return Selector(controls, triangulation, nodes, moved, places).select();
}

}  // namespace pfem
