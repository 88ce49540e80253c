#include "solver/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfem {

namespace {

/// When a point with the velocity w comes within `distance` of one that is at r and rests; infinite: never,
/// or it is there and leaves.
template <int Dim>
double timeToMeet(const Vec<Dim>& r, const Vec<Dim>& w, double distance) {
    const double closing = r.dot(w);
    if (!(closing > 0)) return std::numeric_limits<double>::infinity();
    const double apart = r.squaredNorm() - distance * distance;
    if (apart <= 0) return 0;
    const double hits = closing * closing - w.squaredNorm() * apart;
    return hits < 0 ? std::numeric_limits<double>::infinity() : apart / (closing + std::sqrt(hits));
}

}  // namespace

template <int Dim>
double strikingRate(const State<Dim>& state, const std::vector<unsigned char>& drops, int drop) {
    const auto& nodes = state.nodes;
    const double h = nodes.h[drop], speed = nodes.v[drop].norm();
    double soonest = std::numeric_limits<double>::infinity();
    if (nodes.a[drop].norm() > 0) soonest = h / speed + std::sqrt(h / nodes.a[drop].norm());
    for (int i = 0; i < nodes.size(); ++i) {
        if (drops[i]) continue;
        const Vec<Dim> w = nodes.v[drop] - nodes.v[i];
        const double t = timeToMeet<Dim>(nodes.x[i] - nodes.x[drop], w, std::max(h, nodes.h[i]));
        soonest = std::min(soonest, h / w.norm() + t);
    }
    return 1 / soonest;
}

#define PFEM_INSTANTIATE(D) template double strikingRate<D>(const State<D>&, const std::vector<unsigned char>&, int);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
