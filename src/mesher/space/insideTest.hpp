#pragma once
// Is a point inside a closed surface? Exact: no point is lost between two triangles.

#include "mesh/bins.hpp"
#include "mesh/triSurface.hpp"

namespace pfem {

class InsideTest {
public:
    explicit InsideTest(const TriSurface& surface);

    /// Parity of the triangles above x. A point of the surface counts as if moved by (e, e^2, e^3), e -> 0: on the
    /// common face of two surfaces it is inside exactly one of them.
    bool operator()(const Vec<3>& x) const;

private:
    bool above(int triangle, const Vec<3>& x) const;

    TriSurface surface_;
    Vec<3> low_, high_;
    Bins<2> columns_;
    mutable std::vector<int> seen_;  // per triangle: the last question it was asked in
    mutable int question_ = 0;
};

}  // namespace pfem
