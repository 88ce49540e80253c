#include "remesh/provenCells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "remesh/spaceDelaunay.hpp"

namespace pfem {

/// Centre x_0 + N/D with N = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b, D = 2 a . (b x c), of the edges a, b, c from
/// x_0. Counting operations, N is wrong by less than 50 u L^4 and D by 80 u L^3; L: longest of the edges, u: round-off.
bool sphereIsWithin(const Points<3>& x, const Simplex<3>& cell, const Region<3>& region) {
    constexpr double u = std::numeric_limits<double>::epsilon(), bound = 128 * u;
    const Vec<3>& first = x[cell[0]];
    const Vec<3> a = x[cell[1]] - first, b = x[cell[2]] - first, c = x[cell[3]] - first;
    const double L2 = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}), L3 = L2 * std::sqrt(L2);
    const Vec<3> bc = b.cross(c);
    const double D = 2 * a.dot(bc), certain = std::abs(D) - bound * L3;
    if (!(certain > 0)) return false;
    const Vec<3> toCentre = (a.squaredNorm() * bc + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)) / D;
    const double radius = toCentre.norm();
    const double error = bound * (L2 * L2 + radius * L3) / certain;
    const double least = radius + 4 * error, scale = first.cwiseAbs().maxCoeff() + radius;
    const Vec<3> reach = Vec<3>::Constant(least + 16 * u * scale), centre = first + toCentre;
    return (centre - reach - region.from).minCoeff() > 0 && (region.to - centre - reach).minCoeff() > 0;
}

ProvenCells provenCells(const Points<3>& x, const std::vector<int>& active, const Bisection<3>& parts, int part,
                        double halo) {
    const Region<3> seen = parts.regions[part].grown(halo);
    std::vector<int> known;
    for (const int i : active)
        if (seen.contains(x[i])) known.push_back(i);
    ProvenCells result;
    const Triangulation<3> triangulation = spaceDelaunay(x, known, &result.coincide);
    const int n = static_cast<int>(triangulation.cells.size());
    std::vector<unsigned char> isOurs(n);
    parallelFor(n, [&](int e) {
        const auto& cell = triangulation.cells[e];
        isOurs[e] = parts.owner[cell[0]] == part && sphereIsWithin(x, cell, seen);
    });
    std::vector<int> number(n, -1);  // among ours
    for (int e = 0; e < n; ++e) {
        if (!isOurs[e]) continue;
        number[e] = static_cast<int>(result.cells.size());
        result.cells.push_back(triangulation.cells[e]);
        result.neighbours.push_back(triangulation.neighbours[e]);
    }
    for (auto& neighbours : result.neighbours)
        for (int& other : neighbours) other = other < 0 ? -1 : number[other];
    return result;
}

}  // namespace pfem
