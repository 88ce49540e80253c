#pragma once
// The divided outlines as chords, and what messages call them. Internal to the checks.

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mesher/sizeField.hpp"

namespace pfem {

struct Chord {
    int a, b;
    int piece;
    bool touches(int node) const { return a == node || b == node; }
    int otherEnd(int node) const { return a == node ? b : a; }
};

/// The chords of the divided outlines, and which of them end at each node.
struct Chords {
    std::vector<Chord> all;
    std::vector<std::vector<int>> at;
    double longest = 0;

    explicit Chords(const BoundaryNodes& boundary) : at(boundary.x.size()) {
        for (std::size_t p = 0; p < boundary.ofPiece.size(); ++p) {
            const auto& chain = boundary.ofPiece[p];
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                for (const int node : {chain[i], chain[i + 1]}) at[node].push_back(static_cast<int>(all.size()));
                all.push_back({chain[i], chain[i + 1], static_cast<int>(p)});
                longest = std::max(longest, (boundary.x[chain[i]] - boundary.x[chain[i + 1]]).norm());
            }
        }
    }
};

/// What messages call the boundary's pieces.
class Names {
public:
    Names(const MeshDescription& mesh, const Arrangement& arrangement) : mesh_(mesh), arrangement_(arrangement) {}

    bool sameOutline(int p, int q) const { return use(p).outline == use(q).outline; }
    std::string title(int piece) const { return titleOf(mesh_, use(piece).outline); }
    /// "edge 2-3": the points of the outline that it joins.
    std::string edge(int piece) const {
        const int from = use(piece).edge, n = static_cast<int>(outline(piece).points.size());
        return fmt::format("edge {}-{}", from, (from + 1) % n);
    }
    Location place(int piece) const {
        return outline(piece).atPoint(use(piece).edge, pointsWord(mesh_, use(piece).outline));
    }
    /// "vertex 3 (0.1 0)": the piece's outline has it next to x.
    std::string point(int piece, const Vec<2>& x) const {
        const auto& points = outline(piece).points;
        const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec<2>& p, const Vec<2>& q) {
            return (p - x).squaredNorm() < (q - x).squaredNorm();
        });
        return fmt::format("{} {} ({:.9g} {:.9g})", arrangement_.isWall(use(piece)) ? "point" : "vertex",
                           nearest - points.begin(), x.x(), x.y());
    }

private:
    /// That of an outline itself, not of one that has it as a hole.
    const PieceUse& use(int piece) const { return arrangement_.pieces[piece].uses.front(); }
    const Outline& outline(int piece) const { return outlineOf(mesh_, use(piece).outline); }

    const MeshDescription& mesh_;
    const Arrangement& arrangement_;
};

}  // namespace pfem
