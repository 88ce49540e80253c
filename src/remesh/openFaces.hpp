#pragma once
// Faces beyond which no cell is known, and cells that come among others.

#include <algorithm>
#include <vector>

#include "base/chosen.hpp"
#include "base/parallel.hpp"
#include "remesh/delaunay.hpp"
#include "remesh/outwardFace.hpp"
#include "remesh/pointBox.hpp"

namespace pfem {

/// A face of known cells beyond which none is known.
struct OpenFace {
    Face<3> face;  // outward
    int cell, opposite;
};

/// All of them in the order of the cells, but for those in a side of the box.
inline std::vector<OpenFace> openFaces(const Triangulation<3>& known, const Points<3>& x, const PointBox& box) {
    const auto faceOf = [&](int side) { return outwardFace(known.cells[side / 4], side % 4); };
    const auto sides = parallelChosen(4 * static_cast<int>(known.cells.size()), [&](int side) {
        return known.neighbours[side / 4][side % 4] < 0 && !box.hasAtSide(x, faceOf(side));
    });
    std::vector<OpenFace> faces;
    faces.reserve(sides.size());
    for (const int side : sides) faces.push_back({faceOf(side), side / 4, side % 4});
    return faces;
}

/// Where each of n cells in order, and each of some that come among them, in order too, goes in the order of all.
class Merged {
public:
    /// `cells`: of the first of the n; added(r): the r-th that comes among them.
    template <class Cell, class Added>
    Merged(Cell cells, int n, int nAdded, const Added& added) : n_(n), before_(nAdded) {
        parallelFor(nAdded, [&](int r) {
            before_[r] = static_cast<int>(std::lower_bound(cells, cells + n, added(r)) - cells);
        });
    }

    /// own(e, place) and other(r, place), by threads.
    template <class Own, class Other>
    void place(const Own& own, const Other& other) const {
        constexpr int block = 512;
        const auto rank = [&](int e) {  // of the first that comes after e
            return static_cast<int>(std::upper_bound(before_.begin(), before_.end(), e) - before_.begin());
        };
        const int nAdded = static_cast<int>(before_.size()), nBlocks = (n_ + block - 1) / block;
#pragma omp parallel for schedule(static) if (n_ > shortLoop)
        for (int b = 0; b < nBlocks; ++b) {
            const int first = b * block;
            for (int e = first, r = rank(first); e < n_ && e < first + block; ++e) {
                while (r < nAdded && before_[r] <= e) ++r;
                own(e, e + r);
            }
        }
        parallelFor(nAdded, [&](int r) { other(r, before_[r] + r); });
    }

private:
    int n_;
    std::vector<int> before_;  // per added one: how many of the n come before
};

}  // namespace pfem
