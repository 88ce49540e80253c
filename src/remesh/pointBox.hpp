#pragma once
// The box that points fill, and what lies in its sides.

#include <vector>

#include "base/types.hpp"

namespace pfem {

struct PointBox {
    Vec<3> low, high;

    PointBox(const Points<3>& x, const std::vector<int>& active) : low(Vec<3>::Zero()), high(low) {
        if (active.empty()) return;
        low = high = x[active[0]];
        for (const int i : active) {
            low = low.cwiseMin(x[i]);
            high = high.cwiseMax(x[i]);
        }
    }

    /// Does the face lie in a side of the box? No point is beyond it then.
    bool hasAtSide(const Points<3>& x, const Face<3>& face) const {
        const Vec<3>&a = x[face[0]], &b = x[face[1]], &c = x[face[2]];
        for (int d = 0; d < 3; ++d)
            if (a[d] == b[d] && a[d] == c[d] && (a[d] == low[d] || a[d] == high[d])) return true;
        return false;
    }
};

}  // namespace pfem
