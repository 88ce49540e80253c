#pragma once
// Points that have passed through faces, while both moved.

#include "mesh/faceBins.hpp"

namespace pfem {

template <int Dim>
class Passages {
public:
    /// Faces (their front is to the left) whose points went from `from` to `x`; both must outlive it.
    Passages(NumberedFaces<Dim> faces, const Points<Dim>& x, const Points<Dim>& from);

    /// The face with the largest number through which a point came on its way from its front to more than `slack` [m]
    /// behind, and within the face on the way; one that stood on the face (and slides over its end) where it arrived.
    /// None: -1.
    int through(const Vec<Dim>& xOld, const Vec<Dim>& xNew, double slack) const;

private:
    bool passed(const Face<Dim>& face, const Vec<Dim>& xOld, const Vec<Dim>& xNew, double slack) const;

    NumberedFaces<Dim> faces_;
    const Points<Dim>&x_, &from_;
    FaceBins<Dim> bins_;
};

}  // namespace pfem
