#include "remesh/mendedDelaunay.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "mesh/sortedFace.hpp"
#include "remesh/openFaces.hpp"
#include "remesh/pointGrid.hpp"
#include "remesh/sharedDelaunay.hpp"

namespace pfem {

namespace {

constexpr Simplex<3> noCell{-1, -1, -1, -1};

/// What is proven of a Delaunay triangulation, and grows.
class Growth {
public:
    Growth(const Points<3>& x, const std::vector<int>& active, double reach)
        : x_(x), box_(x, active), grid_(x, active, box_, reach / 3), reach_(reach) {}

    bool coincide() const { return grid_.coincide(); }

    /// The cells of `last` that are still Delaunay, in their order.
    void takeOver(const Triangulation<3>& last, const std::vector<int>& now) {
        const int n = static_cast<int>(last.cells.size());
        const std::vector<int> taken = parallelChosen(n, [&](int e) {
            const Simplex<3> cell = renamed(last.cells[e], now);
            return cell != noCell && isCell(cell);
        });
        nOld_ = static_cast<int>(taken.size());
        std::vector<int> number(n, -1);
        parallelFor(nOld_, [&](int e) { number[taken[e]] = e; });
        known_.cells.resize(nOld_);
        known_.neighbours.resize(nOld_);
        parallelFor(nOld_, [&](int e) {
            known_.cells[e] = renamed(last.cells[taken[e]], now);
            for (int k = 0; k < 4; ++k) {
                const int other = last.neighbours[taken[e]][k];
                known_.neighbours[e][k] = other < 0 ? -1 : number[other];
            }
        });
    }
    int nCells() const { return static_cast<int>(known_.cells.size()); }

    /// Cells beyond open faces, beyond those of the new ones and so on.
    void grow() {
        std::vector<Face<3>> faces, next;
        const auto open = openFaces(known_, x_, box_);
        open_.reserve(2 * open.size());
        for (const auto& [face, e, k] : open) leaveOpen(face, {e, k}, faces);
        std::vector<Simplex<3>> found;
        while (!faces.empty()) {
            found.resize(faces.size());
            parallelFor(static_cast<int>(faces.size()), [&](int f) { found[f] = cellBeyond(faces[f]); });
            next.clear();
            for (std::size_t f = 0; f < faces.size(); ++f)  // several faces may have found the same cell
                if (found[f] != noCell && open_.count(sorted<3>(faces[f])) > 0) add(found[f], next);
            std::swap(faces, next);
        }
    }

    /// What is known in Triangulator's order: the new ones among the old ones.
    Triangulation<3> inOrder() {
        const auto& cells = known_.cells;
        std::vector<int> order(cells.size() - nOld_);
        std::iota(order.begin(), order.end(), nOld_);
        std::sort(order.begin(), order.end(), [&](int a, int b) { return cells[a] < cells[b]; });
        const Merged merged(cells.begin(), nOld_, static_cast<int>(order.size()),
                            [&](int r) { return cells[order[r]]; });
        std::vector<int> number(cells.size());
        merged.place([&](int e, int to) { number[e] = to; }, [&](int r, int to) { number[order[r]] = to; });
        Triangulation<3> result;
        result.cells.resize(cells.size());
        result.neighbours.resize(cells.size());
        parallelFor(nCells(), [&](int e) {
            result.cells[number[e]] = cells[e];
            for (int k = 0; k < 4; ++k) {
                const int other = known_.neighbours[e][k];
                result.neighbours[number[e]][k] = other < 0 ? -1 : number[other];
            }
        });
        return result;
    }

private:
    struct Side {
        int cell, opposite;
    };
    struct FaceHash {
        std::size_t operator()(const Face<3>& face) const {
            std::size_t sum = 0;
            for (const int node : face) sum = (sum ^ static_cast<std::size_t>(node)) * 0x9e3779b97f4a7c15u;
            return sum ^ (sum >> 32);
        }
    };

    static Simplex<3> renamed(const Simplex<3>& cell, const std::vector<int>& now) {
        Simplex<3> result;
        for (int k = 0; k < 4; ++k) {
            result[k] = now[cell[k]];
            if (result[k] < 0) return noCell;
        }
        return result;
    }

    /// No other point is in its sphere, whatever the round-off.
    bool isCell(const Simplex<3>& cell) const {
        const auto ball = enclosingBall(x_, cell);
        return ball && ball->radius <= reach_ && grid_.holdsNoOther(*ball, cell);
    }

    /// The nodes of an outward face, the smallest first, and one beyond it as a cell in Triangulator's order.
    static Simplex<3> cellOf(const Face<3>& face, int apex) {
        if (apex < face[0]) return {apex, face[0], face[2], face[1]};
        Simplex<3> cell{face[0], face[1], face[2], apex};
        std::rotate(cell.begin() + 1, std::min_element(cell.begin() + 1, cell.end()), cell.end());
        return cell;
    }

    /// The Delaunay cell beyond a face: of the spheres through its nodes, with centres m + t n, that with the smallest
    /// t that meets a point. Looked for in balls that grow; none when it is too large, or when round-off hides which
    /// it is.
    Simplex<3> cellBeyond(const Face<3>& face) const {
        const Vec<3>& a = x_[face[0]];
        const Vec<3> ab = x_[face[1]] - a, ac = x_[face[2]] - a, area = ab.cross(ac);
        const double squaredArea = area.squaredNorm();
        if (!(squaredArea > 0)) return noCell;
        const Vec<3> toMiddle =
            (ac.squaredNorm() * area.cross(ab) + ab.squaredNorm() * ac.cross(area)) / (2 * squaredArea);
        const Vec<3> middle = a + toMiddle, n = area / std::sqrt(squaredArea);
        const double squared = toMiddle.squaredNorm(), least = std::sqrt(squared);
        for (double radius = 1.3 * least; least < reach_; radius *= 1.6) {
            radius = std::min(radius, reach_);
            double smallest = std::numeric_limits<double>::max();
            int apex = -1;
            grid_.any({middle + std::sqrt(radius * radius - squared) * n, radius}, [&](const PointGrid::Place& p) {
                const Vec<3> from = p.x - middle;
                const double height = from.dot(n);
                if (height <= 1e-12 * least || std::find(face.begin(), face.end(), p.number) != face.end())
                    return false;
                const double t = (from.squaredNorm() - squared) / (2 * height);
                if (t < smallest) {
                    smallest = t;
                    apex = p.number;
                }
                return false;
            });
            if (apex >= 0) {
                const Simplex<3> cell = cellOf(face, apex);
                return isCell(cell) ? cell : noCell;
            }
            if (radius >= reach_) break;
        }
        return noCell;
    }

    void leaveOpen(const Face<3>& face, const Side& side, std::vector<Face<3>>& faces) {
        open_[sorted<3>(face)] = side;
        faces.push_back(face);
    }

    void add(const Simplex<3>& cell, std::vector<Face<3>>& faces) {
        const int e = nCells();
        known_.cells.push_back(cell);
        known_.neighbours.push_back({-1, -1, -1, -1});
        for (int k = 0; k < 4; ++k) {
            const auto other = open_.find(sorted<3>(oppositeFace<3>(cell, k)));
            if (other == open_.end()) {
                const Face<3> face = outwardFace(cell, k);
                if (!box_.hasAtSide(x_, face)) leaveOpen(face, {e, k}, faces);
                continue;
            }
            known_.neighbours[e][k] = other->second.cell;
            known_.neighbours[other->second.cell][other->second.opposite] = e;
            open_.erase(other);
        }
    }

    const Points<3>& x_;
    PointBox box_;
    PointGrid grid_;
    double reach_;
    Triangulation<3> known_;
    int nOld_ = 0;  // of last time, the first ones
    std::unordered_map<Face<3>, Side, FaceHash> open_;
};

}  // namespace

std::optional<Triangulation<3>> mendedDelaunay(const Points<3>& x, const std::vector<int>& active,
                                               const Triangulation<3>& last, const std::vector<int>& now,
                                               double reach) {
    Growth growth(x, active, reach);
    if (growth.coincide()) return std::nullopt;
    growth.takeOver(last, now);
    if (2 * static_cast<std::size_t>(growth.nCells()) <= last.cells.size()) return std::nullopt;
    growth.grow();
    return completed(x, active, growth.inOrder());
}

}  // namespace pfem
