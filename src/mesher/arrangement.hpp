#pragma once
// All outlines together: every edge is cut at each vertex of another outline that lies on it, and equal
// pieces are joined, so that bodies and walls which touch share their nodes.

#include <vector>

#include "mesher/outline.hpp"

namespace pfem {

/// One use of a piece by an outline.
struct PieceUse {
    int outline;   // bodies first, then walls
    int edge;      // of that outline; -1: the piece is the rim of a hole in it
    bool forward;  // the outline runs from Piece::a to Piece::b
};

/// A stretch of boundary between two vertices, without a vertex inside.
struct Piece {
    int a, b;  // vertices
    Curve curve;
    bool fixed = false;  // one edge of a structured pattern: not divided
    std::vector<PieceUse> uses;
};

/// A piece as an outline passes it.
struct PieceRef {
    int piece;
    bool forward;
};

struct Arrangement {
    Points<2> vertices;
    std::vector<Piece> pieces;
    std::vector<std::vector<PieceRef>> chains;  // per outline, in its order
    std::vector<int> spikes;                    // per outline: tips of spikes without width that were dropped
    int nBodies = 0;

    bool isWall(const PieceUse& use) const { return use.outline >= nBodies; }
    int startOf(const PieceRef& ref) const { return ref.forward ? pieces[ref.piece].a : pieces[ref.piece].b; }
    int endOf(const PieceRef& ref) const { return ref.forward ? pieces[ref.piece].b : pieces[ref.piece].a; }
    /// Whether the piece bounds the body: as part of its outline, or as part of a hole's (`rim`).
    bool bounds(int piece, int body, bool rim) const;
};

/// Without the vertices that no piece has.
void dropVertices(Arrangement& arrangement);

/// Points nearer than `tolerance` [m] are one vertex. Where a hole touches its body's outline, or another hole, neither
/// bounds the body.
/// Throws UserError: an arc through three points of one line, a vertex between the nodes of a pattern.
Arrangement arrange(const MeshDescription& mesh, double tolerance);

}  // namespace pfem
