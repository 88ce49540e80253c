#pragma once
// Which faces are at a place, or come by it on their ways: found by bins and by each face's box.

#include <optional>
#include <utility>
#include <vector>

#include "mesh/bins.hpp"
#include "mesh/simplex.hpp"

namespace pfem {

/// Faces and what they are called.
template <int Dim>
using NumberedFaces = std::vector<std::pair<int, Face<Dim>>>;

template <int Dim>
class FaceBins {
public:
    /// Faces whose points go from `from` to `x`.
    FaceBins(const NumberedFaces<Dim>& faces, const Points<Dim>& x, const Points<Dim>& from);

    /// f(number) for all faces whose box (of the whole way) comes within `radius` of the box from `low` to `high`; some
    /// come several times.
    template <class F>
    void forEachNear(const Vec<Dim>& low, const Vec<Dim>& high, double radius, F&& f) const {
        if (!bins_) return;
        const Vec<Dim> slack = Vec<Dim>::Constant(radius);
        const Box around{low - slack, high + slack};
        bins_->parallelFor(around.low, around.high, [&](int k) {
            if ((box_[k].low.array() <= around.high.array()).all() &&
                (box_[k].high.array() >= around.low.array()).all())
                f(number_[k]);
        });
    }

private:
    struct Box {
        Vec<Dim> low, high;
    };

    std::vector<int> number_;
    std::vector<Box> box_;
    std::optional<Bins<Dim>> bins_;  // none: no faces
};

}  // namespace pfem
