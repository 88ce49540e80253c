#pragma once
// Which body is where: bodies of closed surfaces, cut out of and cut by others.

#include <memory>
#include <optional>

#include "mesher/space/boxTree.hpp"
#include "mesher/space/insideTest.hpp"

namespace pfem {

/// A body is what lies in one of `all`, in each of `within` and in none of `without`: indices of surfaces.
struct BodySpace {
    std::vector<int> all, within, without;
};

class SpaceDomain {
public:
    /// Closed surfaces, and the bodies that they bound.
    SpaceDomain(std::vector<TriSurface> surfaces, std::vector<BodySpace> bodies);

    /// The first body at x, counted from 1; 0: none.
    int label(const Vec<3>& x) const;
    bool isIn(int body, const Vec<3>& x) const;

    /// Where a segment goes from one label to another.
    struct Crossing {
        Vec<3> x;
        std::pair<int, int> labels;  // the smaller one first
    };
    /// The first one from a on.
    std::optional<Crossing> crossing(const Vec<3>& a, const Vec<3>& b) const;

    const std::vector<TriSurface>& surfaces() const { return surfaces_; }
    const BoxTree& tree() const { return tree_; }
    int surfaceOf(int triangle) const { return owner_[triangle]; }
    const Vec<3>& low() const { return low_; }
    const Vec<3>& high() const { return high_; }

private:
    std::vector<TriSurface> surfaces_;
    std::vector<BodySpace> bodies_;
    std::vector<std::unique_ptr<InsideTest>> inside_;
    std::vector<int> owner_;  // per triangle of the tree
    BoxTree tree_;
    Vec<3> low_, high_;
};

}  // namespace pfem
