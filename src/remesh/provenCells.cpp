#include "remesh/provenCells.hpp"

#include "base/parallel.hpp"
#include "remesh/enclosingBall.hpp"
#include "remesh/spaceDelaunay.hpp"

namespace pfem {

bool sphereIsWithin(const Points<3>& x, const Simplex<3>& cell, const Region<3>& region) {
    const auto ball = enclosingBall(x, cell);
    if (!ball) return false;
    const Vec<3> reach = Vec<3>::Constant(ball->radius);
    return (ball->centre - reach - region.from).minCoeff() > 0 && (region.to - ball->centre - reach).minCoeff() > 0;
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
