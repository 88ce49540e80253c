#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mesher/checks.hpp"
#include "mesher/segmentDistance.hpp"

namespace pfem {

namespace {

/// `outlines`: the bodies without regard to their holes.
void checkOverlaps(const MeshDescription& mesh, const std::vector<Region>& outlines,
                   const std::vector<Region>& regions) {
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (const auto& name : mesh.bodies[i].holes) {
            if (!outlines[i].contains(outlines[bodyIndex(mesh, name)].probe()))
                throw UserError(fmt::format("Body '{}' does not lie inside '{}', whose hole it should fill", name,
                                            mesh.bodies[i].name),
                                mesh.bodies[i].at("holes"));
        }
        if (regions[i].edges.empty())
            throw UserError(fmt::format("The holes of body '{}' leave nothing of it", mesh.bodies[i].name),
                            mesh.bodies[i].at("holes"));
        const Vec<2> probe = regions[i].probe();
        for (std::size_t j = 0; j < regions.size(); ++j) {
            if (i == j || !regions[j].contains(probe)) continue;
            throw UserError(
                fmt::format("Bodies '{}' and '{}' overlap. (A body inside another one: write "
                            "'holes ({});' in '{}'.)",
                            mesh.bodies[i].name, mesh.bodies[j].name, mesh.bodies[i].name, mesh.bodies[j].name),
                mesh.bodies[i].at("vertices"));
        }
    }
}

[[noreturn]] void wrongSide(const Body& body, const Wall& wall) {
    throw UserError(fmt::format("Fluid body '{}' lies on the right of wall '{}'. A wall has its fluid on the left of "
                                "its direction: reverse the order of its points.",
                                body.name, wall.name),
                    wall.at("points"));
}

/// What a wall shares with bodies, piece by piece.
void checkShared(const MeshDescription& mesh, const Arrangement& arrangement, std::vector<std::string>& warnings) {
    for (const auto& piece : arrangement.pieces) {
        for (const auto& wallUse : piece.uses) {
            if (!arrangement.isWall(wallUse)) continue;
            const Wall& wall = mesh.walls[wallUse.outline - arrangement.nBodies];
            int nFluid = 0;
            for (const auto& use : piece.uses) {
                if (arrangement.isWall(use)) {
                    if (use.outline == wallUse.outline && use.edge == wallUse.edge) continue;
                    const Vec<2> x = piece.curve.point(0.5);
                    const std::string at = fmt::format("at ({:.6g} {:.6g})", x.x(), x.y());
                    if (use.outline == wallUse.outline)
                        throw UserError(
                            fmt::format("Wall '{}' runs twice along the same line {}: a wall needs a thickness",
                                        wall.name, at),
                            wall.atPoint(wallUse.edge, "points"));
                    throw UserError(fmt::format("Walls '{}' and '{}' share an edge {}", wall.name,
                                                mesh.walls[use.outline - arrangement.nBodies].name, at),
                                    wall.atPoint(wallUse.edge, "points"));
                }
                const Body& body = mesh.bodies[use.outline];
                if (body.type == BodyType::fluid) {
                    ++nFluid;
                    if (use.forward != wallUse.forward && nFluid == 1) wrongSide(body, wall);
                } else if (use.forward != wallUse.forward) {
                    warnings.push_back(fmt::format("wall '{}' runs along the outside of solid '{}': no wall there",
                                                   wall.name, body.name));
                }
            }
            if (nFluid > 1)
                throw UserError(
                    fmt::format("Wall '{}' has fluid on both sides at ({:.6g} {:.6g}): a wall needs a thickness",
                                wall.name, piece.curve.point(0.5).x(), piece.curve.point(0.5).y()),
                    wall.atPoint(wallUse.edge, "points"));
        }
    }
}

/// Node nearest to, but not on, the wall must see the wall's left side.
void checkSide(const Body& body, const Points<2>& corners, const Wall& wall, const std::vector<int>& chain,
               const Points<2>& x, double tolerance) {
    double best = std::numeric_limits<double>::max();
    double side = 1;
    const int n = static_cast<int>(chain.size()), last = wall.closed ? n : n - 1;
    for (const auto& p : corners) {
        double nearest = std::numeric_limits<double>::max(), sideHere = 1;
        for (int e = 0; e < last; ++e) {
            const Vec<2>&a = x[chain[e]], &b = x[chain[(e + 1) % n]];
            const double distance = segmentDistance(p, a, b);
            if (distance > nearest * (1 - 1e-12)) continue;
            nearest = distance;
            const Vec<2> d = (b - a).normalized();
            const double s = (p - a).dot(d), length = (b - a).norm();
            Vec<2> normal(-d.y(), d.x());
            const Vec<2> foot = s <= 0 ? a : b;
            if (s <= 0 || s >= length) {  // nearest to a corner: the mean of both normals decides
                const int f = s <= 0 ? e - 1 : e + 1;
                if (!wall.closed && (f < 0 || f >= last)) {
                    sideHere = 1;  // a free end has no side
                    continue;
                }
                const Vec<2> o = (x[chain[(f + 1 + n) % n]] - x[chain[(f + n) % n]]).normalized();
                normal += Vec<2>(-o.y(), o.x());
                sideHere = normal.dot(p - foot);
            } else {
                sideHere = normal.dot(p - a);
            }
        }
        if (nearest <= tolerance || nearest >= best) continue;
        best = nearest;
        side = sideHere;
    }
    if (side < 0) wrongSide(body, wall);
}

}  // namespace

std::vector<std::string> checkRegions(const MeshDescription& mesh, const Arrangement& arrangement,
                                      const BoundaryNodes& boundary, const std::vector<Region>& regions) {
    std::vector<std::string> warnings;
    std::vector<Region> outlines;
    for (int b = 0; b < arrangement.nBodies; ++b) outlines.push_back(outlineRegion(b, arrangement, boundary));
    checkOverlaps(mesh, outlines, regions);
    checkShared(mesh, arrangement, warnings);
    for (std::size_t w = 0; w < mesh.walls.size(); ++w) {
        const Wall& wall = mesh.walls[w];
        const int outline = arrangement.nBodies + static_cast<int>(w);
        const auto chain = boundary.chain(arrangement, outline, wall.closed);
        for (std::size_t b = 0; b < regions.size(); ++b) {
            for (const auto& ref : arrangement.chains[outline]) {
                const auto& piece = arrangement.pieces[ref.piece];
                if (piece.uses.size() == 1 && regions[b].contains(piece.curve.point(0.5)))
                    throw UserError(fmt::format("Wall '{}' lies inside body '{}'", wall.name, mesh.bodies[b].name),
                                    wall.at("points"));
            }
            if (!regions[b].fluid) continue;
            Points<2> corners;
            for (const auto& ref : arrangement.chains[b])
                corners.push_back(arrangement.vertices[arrangement.startOf(ref)]);
            checkSide(mesh.bodies[b], corners, wall, chain, boundary.x, 1e-3 * regions[b].h);
        }
    }
    return warnings;
}

}  // namespace pfem
