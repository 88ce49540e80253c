#pragma once
// Straight pieces in space, cut where they meet, as lines between corners.

#include "base/types.hpp"

namespace pfem {

class LineGraph {
public:
    using Piece = std::array<int, 2>;

    /// Points nearer than `tolerance` are one: the first of them.
    explicit LineGraph(double tolerance) : tolerance_(tolerance) {}

    void add(const Vec<3>& a, const Vec<3>& b);

    /// Cut all pieces where others meet or cover them.
    void cut();

    /// Forget the pieces for which `drop(a, b)` holds.
    template <class Drop>
    void removeIf(Drop&& drop) {
        std::erase_if(pieces_, [&](const Piece& p) { return drop(x_[p[0]], x_[p[1]]); });
    }

    /// The pieces joined to lines; they end at branches, at ends and where the direction turns sharply.
    std::vector<Points<3>> lines(double sharpCosine) const;

private:
    int point(const Vec<3>& x);
    void sortPieces();

    double tolerance_;
    Points<3> x_;
    std::vector<Piece> pieces_;
};

}  // namespace pfem
