#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/bins.hpp"
#include "mesher/counts.hpp"
#include "mesher/region.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

namespace {

/// Calls f(x) for the points inside the region of a hexagonal lattice, `scale` times the body's size, row by
/// row.
template <class F>
void forLattice(const Region& region, double scale, F&& f) {
    const double h = scale * region.rowSpacing;
    const Vec<2> e = region.rowDirection, n(-e.y(), e.x());
    const auto local = [&](const Vec<2>& x) {
        const Vec<2> d = x - region.rowOrigin;
        return Vec<2>(d.dot(e), d.dot(n));
    };
    double low = std::numeric_limits<double>::max(), high = -low;
    for (int i = 0; i < region.nBoundary; ++i) {
        const double y = local(region.x[i]).y();
        low = std::min(low, y);
        high = std::max(high, y);
    }
    // rows that fit between parallel sides
    const double ideal = 0.5 * std::sqrt(3.0) * scale * region.h;
    const double rowHeight = (high - low) / nearestCount((high - low) / ideal);
    const auto firstRow = static_cast<long>(std::floor(low / rowHeight));
    const auto nRows = static_cast<long>(std::ceil(high / rowHeight)) - firstRow + 1;
    std::vector<std::vector<double>> crossings(nRows);  // abscissae where the row passes the boundary
    for (const auto& [a, b] : region.edges) {
        Vec<2> p = local(region.x[a]), q = local(region.x[b]);
        if (p.y() > q.y()) std::swap(p, q);
        // half open, by the same comparison for both edges at a vertex, so that a vertex on a row counts once
        for (long r = std::lround(std::floor(p.y() / rowHeight)); r * rowHeight < q.y(); ++r) {
            if (r * rowHeight < p.y()) continue;
            const double s = (r * rowHeight - p.y()) / (q.y() - p.y());
            crossings[r - firstRow].push_back(p.x() + s * (q.x() - p.x()));
        }
    }
    for (long r = 0; r < nRows; ++r) {
        auto& at = crossings[r];
        std::sort(at.begin(), at.end());
        const double shift = ((r + firstRow) & 1) ? 0.5 * h : 0.0;
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
            for (long i = std::lround(std::ceil((at[k] - shift) / h)); i * h + shift < at[k + 1]; ++i)
                f(Vec<2>(region.rowOrigin + (i * h + shift) * e + (r + firstRow) * rowHeight * n));
        }
    }
}

}  // namespace

namespace {

/// Points not nearer to the boundary than `clearance` times the size.
void seedAt(Region& region, const SizeField& size, double clearance) {
    constexpr double spacing = 0.8;  // least distance between points of different lattices / size
    Bins<2> boundary(region.x, region.h), points = boundary;
    for (int e = 0; e < static_cast<int>(region.edges.size()); ++e) {
        const Vec<2>&a = region.x[region.edges[e][0]], &b = region.x[region.edges[e][1]];
        boundary.add(e, a.cwiseMin(b), a.cwiseMax(b));
    }
    for (int i = region.nBoundary; i < static_cast<int>(region.x.size()); ++i) points.add(i, region.x[i], region.x[i]);

    const bool graded = size.graded(region.h);
    const double ratio = 1.25;
    const int levels = graded ? countAbove(std::log(region.h / size.smallest()) / std::log(ratio)) : 0;
    for (int level = levels; level >= 0; --level) {
        const double h = region.h / std::pow(ratio, level);
        forLattice(region, h / region.h, [&](const Vec<2>& x) {
            const double s = size.at(x, region.h);
            if (graded && (s > h * std::sqrt(ratio) || (s <= h / std::sqrt(ratio) && level < levels))) return;
            const double least = s * (1 - lengthRoundOff);  // points of the lattice are often just as far
            bool free = true;
            boundary.forEachNear(x, clearance * s, [&](int e) {
                free = free && segmentDistance(x, region.x[region.edges[e][0]], region.x[region.edges[e][1]]) >=
                                   clearance * least;
            });
            if (!free) return;
            points.forEachNear(x, spacing * s,
                               [&](int i) { free = free && (region.x[i] - x).norm() >= spacing * least; });
            if (!free) return;
            points.add(static_cast<int>(region.x.size()), x, x);
            region.x.push_back(x);
        });
    }
}

}  // namespace

// A body a few edges wide gets too many or too few points with one rule for the first row: of several the one
// which comes nearest to the number of equilateral triangles is taken.
void seedLattice(Region& region, const SizeField& size) {
    const double wanted = region.area() / (0.25 * std::sqrt(3.0) * region.h * region.h);
    const auto triangles = [&](std::size_t nPoints) {  // Euler's formula; a hole adds two
        return 2.0 * static_cast<double>(nPoints) - region.nBoundary - 2 + 2 * (region.nLoops - 1);
    };
    const Points<2> start = region.x;
    Points<2> best;
    double leastError = std::numeric_limits<double>::max();
    for (const double clearance : {0.6, 0.55, 0.5, 0.65, 0.7}) {
        region.x = start;
        seedAt(region, size, clearance);
        const double error = std::abs(triangles(region.x.size()) / wanted - 1);
        if (error < leastError) {
            leastError = error;
            best = region.x;
        }
        if (leastError < 0.02 || size.graded(region.h)) break;
    }
    region.x = best;
}

}  // namespace pfem
