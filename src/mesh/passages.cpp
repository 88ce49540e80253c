#include "mesh/passages.hpp"

#include <algorithm>

#include "mesh/distance.hpp"

namespace pfem {

namespace {

/// How far a point is before the plane of a face [m].
template <int Dim>
double distanceBefore(const Face<Dim>& face, const Points<Dim>& x, const Vec<Dim>& point) {
    return -faceArea<Dim>(x, face).normalized().dot(point - x[face[0]]);
}

/// The faces, called by their places in the list.
template <int Dim>
NumberedFaces<Dim> placesOf(NumberedFaces<Dim> faces) {
    for (std::size_t k = 0; k < faces.size(); ++k) faces[k].first = static_cast<int>(k);
    return faces;
}

}  // namespace

template <int Dim>
Passages<Dim>::Passages(NumberedFaces<Dim> faces, const Points<Dim>& x, const Points<Dim>& from)
    : faces_(std::move(faces)), x_(x), from_(from), bins_(placesOf<Dim>(faces_), x, from) {}

template <int Dim>
bool Passages<Dim>::passed(const Face<Dim>& face, const Vec<Dim>& xOld, const Vec<Dim>& xNew, double slack) const {
    const double before = distanceBefore<Dim>(face, from_, xOld), after = distanceBefore<Dim>(face, x_, xNew);
    if (!(before > -1e-7 * slack && after < -slack))
        return false;  // what came round an end was behind it, and did not land
    const double part = before > slack ? before / (before - after) : 1;  // of the way
    Points<Dim> then(Dim);
    Face<Dim> all{};
    for (int k = 0; k < Dim; ++k) {
        all[k] = k;
        then[k] = from_[face[k]] + part * (x_[face[k]] - from_[face[k]]);
    }
    return footWeights<Dim>(then, all, xOld + part * (xNew - xOld)).minCoeff() > 0;
}

template <int Dim>
int Passages<Dim>::through(const Vec<Dim>& xOld, const Vec<Dim>& xNew, double slack) const {
    int found = -1;
    // where a turning face is passed is known but for a part of the way
    bins_.forEachNear(xOld.cwiseMin(xNew), xOld.cwiseMax(xNew), (xNew - xOld).norm() + slack, [&](int k) {
        const auto& [number, face] = faces_[k];
        if (number > found && passed(face, xOld, xNew, slack)) found = number;
    });
    return found;
}

template class Passages<2>;
template class Passages<3>;

}  // namespace pfem
