#include "remesh/nodeControl.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "base/parallel.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

namespace {

template <int Dim>
class Planner {
public:
    Planner(const RemeshingControls& controls, const MovedMesh<Dim>& moved, const std::vector<double>& h,
            const std::vector<unsigned char>& kept)
        : controls_(controls),
          moved_(moved),
          h_(h),
          kept_(kept),
          ring_(moved.topology.ring),
          locked_(moved.x.size(), 0),
          near_(moved.x.size(), 0),
          long_(moved.x.size(), 0) {
        plan_.removed.assign(moved.x.size(), 0);
        findBoundaryEdges();
        findHeights();
        closest_ = std::max(controls.removeDistance, controls.removeDistanceSurface);
        parallelFor(static_cast<int>(moved.x.size()), [&](int i) {  // most nodes need no second look
            for (int s = ring_.start[i]; s < ring_.start[i + 1]; ++s) {
                const double distance = distanceTo(ring_.node[s], moved_.x[i], h_[i]);
                near_[i] |= distance < closest_;
                long_[i] |= distance >= controls.insertDistance;
            }
        });
    }

    NodePlan<Dim> plan(const std::vector<int>& pinched) {
        for (const int i : pinched)
            if (!isImage(i) && !locked_[own(i)] && !stays(i)) remove(i);
        removeAtCorners();
        removeClose();
        insertInLongEdges();
        moved_.images.follow(plan_.removed);
        keepSurface();
        return std::move(plan_);
    }

private:
    /// Decisions are made once, for the node that is no image; it and its images are locked together.
    bool isImage(int i) const { return moved_.images.isImage(i); }
    int own(int i) const { return moved_.images.own(i); }

    /// Of a face and its copies, the one that counts.
    bool isOwnFace(const Face<Dim>& face) const {
        return !isImage(*std::min_element(face.begin(), face.end(), [&](int i, int j) { return own(i) < own(j); }));
    }

    /// A node that slides towards one that more walls hold, or a solid on its wall: nothing could stop it there.
    void removeAtCorners() {
        const auto& t = moved_.topology;
        const auto& x = moved_.x;
        const int n = static_cast<int>(x.size());
        std::vector<int> corners;
        for (int i = 0; i < n; ++i)
            if (isSupported(t.supports[i]) && !t.isUnderSkin(i) && (t.onSolid[i] || nSupports(t.supports[i]) > 1))
                corners.push_back(i);
        std::sort(corners.begin(), corners.end(), [&](int a, int b) { return x[a][0] < x[b][0]; });
        for (int i = 0; i < n; ++i) {
            if (!t.onWall[i] || kept_[i] || isImage(i)) continue;
            const double reach = (1 + 1e-9) * controls_.expert.walls.cornerDistance * h_[i];
            auto corner = std::lower_bound(corners.begin(), corners.end(), x[i][0] - reach,
                                           [&](int c, double least) { return x[c][0] < least; });
            for (; corner != corners.end() && x[*corner][0] <= x[i][0] + reach; ++corner)
                if (isNear(i, *corner) &&
                    (t.onSolid[*corner] || nSupports(t.supports[*corner]) > nSupports(t.supports[i])) &&
                    t.supportOn(*corner, t.supports[i][0]) >= 0)
                    remove(i);
        }
    }

    /// Stays whoever comes: of solids, patches and corners of the walls.
    bool stays(int i) const { return kept_[i] || nSupports(moved_.topology.supports[i]) == Dim; }

    bool isNear(int i, int corner) const {
        return !locked_[own(i)] &&
               (moved_.x[i] - moved_.x[corner]).norm() <= controls_.expert.walls.cornerDistance * h_[i];
    }

    void remove(int i) {
        plan_.removed[i] = 1;
        lockPatch(i);
    }

    /// Nodes of no boundary in a flat cell under the surface: the surface stays, and so does the volume.
    std::vector<unsigned char> isUnderSurface() const {
        const auto& t = moved_.topology;
        std::vector<unsigned char> under(moved_.x.size(), 0);
        for (const auto& face : t.faces) {
            if (face.kind != FaceKind::freeSurface) continue;
            const auto& cell = moved_.fluid[face.cell];
            const double volume = Dim * simplexMeasure<Dim>(moved_.x, cell),
                         area = faceArea<Dim>(moved_.x, face.nodes).norm();
            for (int i : cell)
                under[i] |= !t.freeSurface[i] && !t.onWall[i] && volume < controls_.expert.removeHeight * h_[i] * area;
        }
        return under;
    }

    void removeClose() {
        const auto under = isUnderSurface();
        for (int i = 0; i < static_cast<int>(moved_.x.size()); ++i) {
            if (stays(i) || isImage(i) || locked_[own(i)] || !moved_.topology.wet(i)) continue;
            if (under[i] || (near_[i] && isTooClose(i))) remove(i);
        }
    }

    bool isTooClose(int i) const {
        const bool slides = moved_.topology.onWall[i];
        const bool surface = moved_.topology.freeSurface[i] || slides, inFilm = surface && isInFilm(i);
        for (int s = ring_.start[i]; s < ring_.start[i + 1]; ++s) {
            const int j = ring_.node[s];
            if (locked_[own(j)] && !stays(j)) continue;
            // a node on a wall gives way only to its neighbours along the wall
            if (slides && !moved_.topology.onWall[j] && !stays(j)) continue;
            // and the contact line to none that is under water: that one can go without a change of volume
            if (slides && moved_.topology.freeSurface[i] && !moved_.topology.freeSurface[j] && !stays(j)) continue;
            const double distance = distanceTo(j, moved_.x[i], h_[i]);
            if (distance < closest_ && distance < distanceFrom(j, surface, inFilm || !isBoundaryEdge(i, j)))
                return true;
        }
        return false;
    }

    /// From node j to a node at x of mesh size h, in units of their mean mesh size.
    double distanceTo(int j, const Vec<Dim>& x, double h) const {
        return (moved_.x[j] - x).norm() / (0.5 * (h_[j] + h));
    }

    /// How near to j a node may come: one of the surface gives way to nodes of the boundary alone, and to those across
    /// a film with two free sides, or at the end of one, only when it is as thin as removeDistanceFilm h. Else it would
    /// go with them.
    double distanceFrom(int j, bool surface, bool film) const {
        if (!surface) return controls_.removeDistance;
        if (film && moved_.topology.freeSurface[j] && !stays(j))
            return std::min(controls_.expert.removeDistanceFilm, controls_.removeDistanceSurface);
        const bool boundary = moved_.topology.freeSurface[j] || moved_.topology.onWall[j] || kept_[j];
        return boundary ? controls_.removeDistanceSurface : 0;
    }

    /// A node of the surface with neighbours of the surface alone: the fluid is one cell thick there (or the node an
    /// ear).
    bool isInFilm(int i) const {
        const auto& free = moved_.topology.freeSurface;
        return free[i] && std::all_of(ring_.node.begin() + ring_.start[i], ring_.node.begin() + ring_.start[i + 1],
                                      [&](int j) { return free[j]; });
    }

    void insertInLongEdges() {
        for (int i = 0; i < static_cast<int>(moved_.x.size()); ++i)
            for (int s = ring_.start[i]; long_[i] && !isImage(i) && s < ring_.start[i + 1]; ++s) {
                const int j = ring_.node[s];
                if (own(j) < i || locked_[own(i)] || locked_[own(j)]) continue;
                if (distanceTo(j, moved_.x[i], h_[i]) < controls_.insertDistance) continue;
                if (kept_[i] == 1 && kept_[j] == 1 && isBoundaryEdge(i, j)) continue;
                if (closesGap(i, j) || wouldGoAgain(i, j)) continue;
                plan_.inserted.push_back({i, j});  // i has the lower master
                locked_[own(i)] = locked_[own(j)] = 1;
            }
    }

    /// From a wall to a solid that touches it, over what is left of the fluid between them: it goes, and the edge
    /// becomes a face on the wall. A node in its middle would be on no wall, and the cell between the three without
    /// area.
    bool closesGap(int i, int j) const {
        const auto& t = moved_.topology;
        if (t.onSolid[i] == t.onSolid[j] || !isSupported(t.supports[i]) || isBoundaryEdge(i, j)) return false;
        return std::any_of(t.supports[i].begin(), t.supports[i].end(),
                           [&](int wall) { return wall >= 0 && t.supportOn(j, wall) >= 0; });
    }

    /// Would the midpoint be too close to a node opposite to the edge, or too low under the surface? Then the next
    /// remeshing would remove one of them; in a film, again and again, and its sides could never be divided.
    bool wouldGoAgain(int i, int j) const {
        const bool surface = isBoundaryEdge(i, j);
        const Vec<Dim> middle = 0.5 * (moved_.x[i] + moved_.x[j]);
        const auto& around = moved_.topology.fluid;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& cell = moved_.fluid[around.cell[s]];
            if (std::find(cell.begin(), cell.end(), j) == cell.end()) continue;
            if (!surface && 0.5 * height_[around.cell[s]] < controls_.expert.removeHeight * 0.5 * (h_[i] + h_[j]))
                return true;
            for (int node : cell)
                if (node != i && node != j &&
                    distanceTo(node, middle, 0.5 * (h_[i] + h_[j])) < distanceFrom(node, surface, true))
                    return true;
        }
        return false;
    }

    bool isBoundaryEdge(int i, int j) const {
        if constexpr (Dim == 3) {
            const int low = std::min(i, j);
            const auto from = upperEnds_.begin();
            const auto last = from + edgeStart_[low + 1];
            return std::find(from + edgeStart_[low], last, std::max(i, j)) != last;
        }
        int cells = 0;
        const auto& around = moved_.topology.fluid;
        for (int s = around.start[i]; s < around.start[i + 1]; ++s) {
            const auto& cell = moved_.fluid[around.cell[s]];
            cells += std::find(cell.begin(), cell.end(), j) != cell.end();
        }
        return cells < 2;
    }

    void findHeights() {
        height_.assign(moved_.fluid.size(), std::numeric_limits<double>::max());
        for (const auto& face : moved_.topology.faces) {
            if (face.kind != FaceKind::freeSurface) continue;
            const double height = Dim * simplexMeasure<Dim>(moved_.x, moved_.fluid[face.cell]) /
                                  faceArea<Dim>(moved_.x, face.nodes).norm();
            height_[face.cell] = std::min(height_[face.cell], height);
        }
    }

    void findBoundaryEdges() {
        if (Dim == 2) return;
        const auto forEdges = [&](const auto& visit) {
            for (const auto& face : moved_.topology.faces)
                for (int k = 0; k < 3; ++k) {
                    const int i = face.nodes[k % Dim], j = face.nodes[(k + 1) % Dim];
                    visit(std::min(i, j), std::max(i, j));
                }
        };
        edgeStart_.assign(moved_.x.size() + 2, 0);
        forEdges([&](int low, int) { ++edgeStart_[low + 2]; });
        std::partial_sum(edgeStart_.begin(), edgeStart_.end(), edgeStart_.begin());
        upperEnds_.resize(edgeStart_.back());
        forEdges([&](int low, int high) { upperEnds_[edgeStart_[low + 1]++] = high; });
    }

    /// The surface polygon without removed nodes and with the halves of split edges.
    void keepSurface() {
        if constexpr (Dim == 2) {
            std::map<int, int> next;  // along the surface, fluid on the left
            for (const auto& face : moved_.topology.faces)
                if (face.kind == FaceKind::freeSurface) next[face.nodes[0]] = face.nodes[1];
            std::map<std::array<int, 2>, int> middle;
            for (std::size_t k = 0; k < plan_.inserted.size(); ++k)
                middle[plan_.inserted[k]] = static_cast<int>(moved_.x.size() + k);
            for (const auto& face : moved_.topology.faces) {
                if (face.kind != FaceKind::freeSurface || plan_.removed[face.nodes[0]] || !isOwnFace(face.nodes))
                    continue;
                const int a = face.nodes[0];
                int b = face.nodes[1];
                if (plan_.removed[b]) {  // its neighbours stay: one removal per patch
                    const auto after = next.find(b);
                    if (after == next.end()) continue;
                    plan_.cuts.push_back({a, b, after->second});
                    b = after->second;
                }
                const auto mid = middle.find({std::min(a, b), std::max(a, b)});
                if (mid == middle.end()) {
                    plan_.surface.push_back({a, b});
                } else {
                    plan_.surface.push_back({a, mid->second});
                    plan_.surface.push_back({mid->second, b});
                }
            }
        }
    }

    void lockPatch(int i) {
        locked_[own(i)] = 1;
        for (int s = ring_.start[i]; s < ring_.start[i + 1]; ++s) locked_[own(ring_.node[s])] = 1;
    }

    const RemeshingControls& controls_;
    const MovedMesh<Dim>& moved_;
    const std::vector<double>& h_;
    const std::vector<unsigned char>& kept_;
    const NodeToNodes& ring_;
    std::vector<int> edgeStart_, upperEnds_;  // (3D) edges of faces without a neighbour, by their lower nodes
    std::vector<double> height_;              // per cell, the least over a face of the free surface [m]
    double closest_ = 0;                      // in units of h: no node goes for one that is farther
    std::vector<unsigned char> locked_;
    std::vector<unsigned char> near_;  // to a neighbour: such a node may have to go
    std::vector<unsigned char> long_;  // the end of an edge that may get a node
    NodePlan<Dim> plan_;
};

}  // namespace

template <int Dim>
NodePlan<Dim> planNodes(const RemeshingControls& controls, const MovedMesh<Dim>& moved, const std::vector<double>& h,
                        const std::vector<unsigned char>& kept, const std::vector<int>& pinched) {
    return Planner<Dim>(controls, moved, h, kept).plan(pinched);
}

#define PFEM_INSTANTIATE(D)                                                                                      \
    template NodePlan<D> planNodes<D>(const RemeshingControls&, const MovedMesh<D>&, const std::vector<double>&, \
                                      const std::vector<unsigned char>&, const std::vector<int>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
