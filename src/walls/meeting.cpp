#include "walls/meeting.hpp"

#include <Eigen/LU>
#include <cmath>

namespace pfem {

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
    for (int k = 0; k < count; ++k) {
        const auto place = placeOnRegion<Dim>(walls, x, meeting.walls[k], meeting.x);
        if (count > 1 && !((place.x - meeting.x).norm() < near)) return std::nullopt;
        meeting.walls[k] = place.face;
        if (count == 1) meeting.x = place.x;
    }
    return meeting;
}

#define PFEM_INSTANTIATE(D)                                                                            \
    template std::optional<Meeting<D>> meetingOf<D>(const std::vector<WallFace<D>>&, const Points<D>&, \
                                                    const Supports<D>&, const Vec<D>&, double);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
