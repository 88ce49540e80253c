#include "base/vectors.hpp"
#include "mesher/constrainedDelaunay.hpp"
#include "mesher/region.hpp"

namespace pfem {

namespace {

constexpr int sweeps = 30;

/// Centre of the circle through the triangle's corners.
Vec<2> circumcentre(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const Vec<2> u = b - a, w = c - a;
    return a + Vec<2>(w.y() * u.squaredNorm() - u.y() * w.squaredNorm(),
                      u.x() * w.squaredNorm() - w.x() * u.squaredNorm()) /
                   (2 * cross(u, w));
}

}  // namespace

// Optimal Delaunay smoothing: each point goes to the mean of its triangles' circumcentres, weighted with
// area / size^3 (a finer region counts as many triangles as a coarse one), then the points are triangulated
// again. The hexagonal lattice is its fixed point: only the seam along the boundary moves.
std::vector<Simplex<2>> smoothAndTriangulate(Region& region, const SizeField& size) {
    const int n = static_cast<int>(region.x.size());
    auto triangles = triangulate(region.x, region.edges);
    if (region.nBoundary == n) return triangles;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        Points<2> sum(n, Vec<2>::Zero());
        std::vector<double> weight(n, 0.0);
        for (const auto& t : triangles) {
            const Vec<2>&a = region.x[t[0]], &b = region.x[t[1]], &c = region.x[t[2]];
            const double h = size.at((a + b + c) / 3, region.h);
            const double w = cross(b - a, c - a) / (h * h * h);
            const Vec<2> centre = circumcentre(a, b, c);
            for (const int i : t) {
                sum[i] += w * centre;
                weight[i] += w;
            }
        }
        for (int i = region.nBoundary; i < n; ++i) region.x[i] = sum[i] / weight[i];
        for (std::size_t k = 0; k < region.anchors.size(); ++k) {
            const auto& [centre, radius] = region.anchors[k];
            Vec<2>& x = region.x[region.nBoundary + k];
            const double distance = (x - centre).norm();
            if (distance > radius) x = Vec<2>(centre + radius / distance * (x - centre));
        }
        triangles = triangulate(region.x, region.edges);
    }
    return triangles;
}

std::vector<Simplex<2>> fillUnstructured(Region& region, const SizeField& size) {
    seedCorners(region);
    seedLattice(region, size);
    return smoothAndTriangulate(region, size);
}

}  // namespace pfem
