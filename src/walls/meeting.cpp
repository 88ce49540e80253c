#include "walls/meeting.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace pfem {

namespace {

/// How far a place on a wall is from the straight face there [m].
template <int Dim>
double bulgeAt(const WallFace<Dim>& wall, const Points<Dim>& x, const Vec<Dim>& place) {
    return wall.bent ? std::abs(inwardNormal<Dim>(x, wall.nodes).dot(place - x[wall.nodes[0]])) : 0;
}

}  // namespace

template <int Dim>
std::optional<Meeting<Dim>> meetingOf(const std::vector<WallFace<Dim>>& walls, const Points<Dim>& x,
                                      const Supports<Dim>& supports, const Vec<Dim>& start, double near) {
    Meeting<Dim> meeting{start, supports};
    const int count = nSupports(supports);
    constexpr int turns = 4;  // bent walls: Newton's steps
    for (int turn = 0; count > 1 && turn < turns; ++turn) {
        Eigen::Matrix<double, Dim, Eigen::Dynamic, 0, Dim, Dim> N(Dim, count);
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Dim, 1> off(count);
        for (int k = 0; k < count; ++k) {
            const auto place = placeOnRegion<Dim>(walls, x, meeting.walls[k], meeting.x);
            meeting.walls[k] = place.face;
            N.col(k) = place.normal;
            off[k] = place.normal.dot(place.x - meeting.x);
        }
        const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Dim, Dim> metric = N.transpose() * N;
        if (!(metric.determinant() > 1e-6)) return std::nullopt;
        meeting.x += N * metric.inverse() * off;
    }
    // where a straight wall ends in chords the bent one beside it bulges out of them
    double farthest = 0, bulge = 0;
    for (int k = 0; k < count; ++k) {
        const auto place = placeOnRegion<Dim>(walls, x, meeting.walls[k], meeting.x);
        meeting.walls[k] = place.face;
        farthest = std::max(farthest, (place.x - meeting.x).norm());
        bulge = std::max(bulge, bulgeAt<Dim>(walls[place.face], x, place.x));
        if (count == 1) meeting.x = place.x;
    }
    if (count > 1 && !(farthest < near + bulge)) return std::nullopt;
    return meeting;
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template std::optional<Meeting<D>> meetingOf<D>(const std::vector<WallFace<D>>&, const Points<D>&, \
                                                    const Supports<D>&, const Vec<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
