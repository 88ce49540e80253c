#pragma once
// The wanted edge length everywhere: a body's own size, growing gently away from finer boundaries and refinements.

#include "mesher/arrangement.hpp"

namespace pfem {

class SizeField {
public:
    /// Each piece has the smallest size of the bodies that own it; a wall's own meshSize counts too,
    /// the dictionary's default only where no body touches the wall.
    SizeField(const MeshDescription& mesh, const Arrangement& arrangement);

    /// Wanted edge length at x where nothing finer is near: `cap` [m].
    double at(const Vec<2>& x, double cap) const;

    double ofPiece(int piece) const { return pieceSize_[piece]; }
    double ofBody(int body) const { return bodySize_[body]; }
    double smallest() const;

    /// Whether `at` can give clearly less than `cap` somewhere.
    bool graded(double cap) const;

private:
    struct Source {
        Vec<2> x;
        double h;
    };
    std::vector<double> pieceSize_, bodySize_;
    std::vector<Source> sources_;  // sorted by h
    std::vector<Refinement> refinements_;
};

/// Nodes of all pieces: those of piece i run from Piece::a to Piece::b in `ofPiece[i]`.
/// The first nodes are the vertices.
struct BoundaryNodes {
    Points<2> x;
    std::vector<double> h;
    std::vector<std::vector<int>> ofPiece;

    /// The nodes along an outline, in its order (the first is not repeated for a closed one).
    std::vector<int> chain(const Arrangement& arrangement, int outline, bool closed) const;
};

/// Divide every piece evenly (or by the graded size) at the target length.
BoundaryNodes divideBoundary(const Arrangement& arrangement, const SizeField& size);

}  // namespace pfem
