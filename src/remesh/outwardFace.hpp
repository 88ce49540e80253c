#pragma once
// Faces of tetrahedra as they are seen from outside.

#include <algorithm>

#include "mesh/simplex.hpp"

namespace pfem {

/// The outward face opposite to node k, its smallest node first.
inline Face<3> outwardFace(const Simplex<3>& cell, int k) {
    Face<3> face = oppositeFace<3>(cell, k);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

inline Face<3> turnedRound(const Face<3>& face) { return {face[0], face[2], face[1]}; }

/// The box that points fill.
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
