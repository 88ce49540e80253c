#include "mesher/arrangement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pfem {

namespace {

/// An edge of an outline, or a part of one, before the cutting.
struct RawEdge {
    int a, b;
    Curve curve;
    int outline, edge;
    bool fixed;
};

/// The vertices found so far, in order and by their x coordinate.
struct Vertices {
    Points<2> x;
    std::multimap<double, int> byX;

    /// The first one within `tolerance`, or a new one.
    int findOrAdd(const Vec<2>& point, double tolerance) {
        int found = -1;
        for (auto it = byX.lower_bound(point.x() - tolerance); it != byX.end() && it->first <= point.x() + tolerance;
             ++it)
            if ((x[it->second] - point).norm() <= tolerance && (found < 0 || it->second < found)) found = it->second;
        if (found >= 0) return found;
        x.push_back(point);
        byX.emplace(point.x(), static_cast<int>(x.size()) - 1);
        return static_cast<int>(x.size()) - 1;
    }
};

void addEdges(const Outline& outline, int index, const std::vector<int>& divisions, double tolerance,
              Vertices& vertices, std::vector<RawEdge>& edges) {
    for (int e = 0; e < outline.nEdges(); ++e) {
        const Curve curve = edgeCurve(outline, e);
        const int n = divisions.empty() ? 1 : divisions[e];
        int a = vertices.findOrAdd(curve.point(0), tolerance);
        for (int i = 0; i < n; ++i) {
            const double s0 = double(i) / n, s1 = double(i + 1) / n;
            const int b = vertices.findOrAdd(curve.point(s1), tolerance);
            if (a != b)
                edges.push_back({a, b, curve.part(s0, s1, vertices.x[a], vertices.x[b]), index, e, !divisions.empty()});
            a = b;
        }
    }
}

/// The vertices inside the edge, in order: pairs of parameter and vertex, with both ends.
std::vector<std::pair<double, int>> cuts(const RawEdge& e, const Vertices& vertices, double tolerance) {
    std::vector<std::pair<double, int>> at = {{0.0, e.a}, {1.0, e.b}};
    const auto [low, high] = std::minmax(vertices.x[e.a].x(), vertices.x[e.b].x());
    auto it = e.curve.isArc() ? vertices.byX.begin() : vertices.byX.lower_bound(low - tolerance);
    const auto end = e.curve.isArc() ? vertices.byX.end() : vertices.byX.upper_bound(high + tolerance);
    for (; it != end; ++it) {
        const int v = it->second;
        if (v == e.a || v == e.b) continue;
        if (const auto s = e.curve.parameterOf(vertices.x[v], tolerance)) at.emplace_back(*s, v);
    }
    std::sort(at.begin(), at.end());
    return at;
}

[[noreturn]] void patternCut(const MeshDescription& mesh, const RawEdge& e, const Vec<2>& x) {
    const Body& body = mesh.bodies[e.outline];
    throw UserError(fmt::format("A vertex at ({:g} {:g}) lies between two nodes of the structured body '{}'.\n"
                                "Choose 'cells' so that one of its nodes falls there, or leave out 'pattern'.",
                                x.x(), x.y(), body.name),
                    body.at("pattern"));
}

/// The rim of a hole, and of the same body the outline or the rim of another hole in the other direction: the body is
/// on neither side.
void cancelHoles(std::vector<PieceUse>& uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i].edge >= 0) continue;
        const PieceUse rim = uses[i];
        const auto other = std::find_if(uses.begin(), uses.end(), [&](const PieceUse& use) {
            return use.outline == rim.outline && use.forward != rim.forward;
        });
        if (other == uses.end()) continue;
        const auto j = static_cast<std::size_t>(other - uses.begin());
        uses.erase(uses.begin() + static_cast<long>(std::max(i, j)));
        uses.erase(uses.begin() + static_cast<long>(std::min(i, j)));
        i = static_cast<std::size_t>(-1);  // from the beginning
    }
}

/// Where the outline goes there and back along one piece it goes nowhere.
void dropSpikes(int outline, Arrangement& arrangement) {
    auto& chain = arrangement.chains[outline];
    const auto isSpike = [&](const PieceRef& p, const PieceRef& q) {
        return p.piece == q.piece && p.forward != q.forward;
    };
    const auto dropUses = [&](const PieceRef& ref) {
        std::erase_if(arrangement.pieces[ref.piece].uses, [&](const PieceUse& use) { return use.outline == outline; });
    };
    std::vector<PieceRef> kept;
    for (const auto& ref : chain) {
        kept.push_back(ref);
        if (kept.size() < 2 || !isSpike(kept[kept.size() - 2], ref)) continue;
        dropUses(ref);
        kept.resize(kept.size() - 2);
        ++arrangement.spikes[outline];
    }
    while (kept.size() > 2 && isSpike(kept.front(), kept.back())) {
        dropUses(kept.front());
        kept.erase(kept.begin());
        kept.pop_back();
        ++arrangement.spikes[outline];
    }
    chain = kept;
}

/// Pieces that no outline uses any more, and vertices that no piece has.
void dropUnused(Arrangement& arrangement) {
    std::vector<int> rank(arrangement.pieces.size(), -1);
    std::vector<Piece> left;
    for (std::size_t p = 0; p < rank.size(); ++p) {
        if (arrangement.pieces[p].uses.empty()) continue;
        rank[p] = static_cast<int>(left.size());
        left.push_back(arrangement.pieces[p]);
    }
    arrangement.pieces = left;
    for (auto& chain : arrangement.chains)
        for (auto& ref : chain) ref.piece = rank[ref.piece];
    dropVertices(arrangement);
}

}  // namespace

void dropVertices(Arrangement& arrangement) {
    std::vector<int> rank(arrangement.vertices.size(), -1);
    for (const auto& piece : arrangement.pieces) rank[piece.a] = rank[piece.b] = 0;
    Points<2> left;
    for (std::size_t v = 0; v < rank.size(); ++v) {
        if (rank[v] < 0) continue;
        rank[v] = static_cast<int>(left.size());
        left.push_back(arrangement.vertices[v]);
    }
    arrangement.vertices = left;
    for (auto& piece : arrangement.pieces) piece.a = rank[piece.a], piece.b = rank[piece.b];
}

bool Arrangement::bounds(int piece, int body, bool rim) const {
    const auto& uses = pieces[piece].uses;
    return std::any_of(uses.begin(), uses.end(),
                       [&](const PieceUse& use) { return use.outline == body && (use.edge < 0) == rim; });
}

Arrangement arrange(const MeshDescription& mesh, double tolerance) {
    Arrangement result;
    result.nBodies = static_cast<int>(mesh.bodies.size());
    std::vector<RawEdge> edges;
    Vertices vertices;
    int index = 0;
    for (const auto& body : mesh.bodies) {
        std::vector<int> divisions;
        if (body.pattern != Pattern::unstructured) {
            const auto [nx, ny] = patternCells(mesh, body);
            divisions = {nx, ny, nx, ny};
        }
        addEdges(body, index++, divisions, tolerance, vertices, edges);
    }
    for (const auto& wall : mesh.walls) addEdges(wall, index++, {}, tolerance, vertices, edges);
    result.vertices = vertices.x;

    result.chains.resize(index);
    result.spikes.assign(index, 0);
    std::multimap<std::pair<int, int>, int> known;  // ends -> piece
    for (const auto& e : edges) {
        const auto at = cuts(e, vertices, tolerance);
        if (e.fixed && at.size() > 2) patternCut(mesh, e, result.vertices[at[1].second]);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const auto [s0, a] = at[i];
            const auto [s1, b] = at[i + 1];
            const Curve curve = e.curve.part(s0, s1, result.vertices[a], result.vertices[b]);
            int piece = -1;
            const auto [first, last] = known.equal_range(std::minmax(a, b));
            for (auto it = first; it != last && piece < 0; ++it)
                if ((result.pieces[it->second].curve.point(0.5) - curve.point(0.5)).norm() <= 2 * tolerance)
                    piece = it->second;
            if (piece < 0) {
                piece = static_cast<int>(result.pieces.size());
                result.pieces.push_back({a, b, curve, false, {}});
                known.emplace(std::minmax(a, b), piece);
            }
            Piece& p = result.pieces[piece];
            const bool forward = p.a == a;
            p.fixed = p.fixed || e.fixed;
            p.uses.push_back({e.outline, e.edge, forward});
            result.chains[e.outline].push_back({piece, forward});
        }
    }
    for (int o = 0; o < index; ++o)
        if (o < result.nBodies || mesh.walls[o - result.nBodies].closed) dropSpikes(o, result);
    dropUnused(result);
    for (int b = 0; b < result.nBodies; ++b)
        for (const auto& hole : mesh.bodies[b].holes)
            for (const auto& ref : result.chains[bodyIndex(mesh, hole)])
                result.pieces[ref.piece].uses.push_back({b, -1, !ref.forward});
    for (Piece& piece : result.pieces) cancelHoles(piece.uses);
    return result;
}

}  // namespace pfem
