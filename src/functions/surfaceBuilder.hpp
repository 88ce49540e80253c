#pragma once
// Points on edges of cells, cells between them, and fields there: a surface for the writer of io.

#include <map>
#include <tuple>

#include "functions/fields.hpp"
#include "functions/planeCut.hpp"
#include "io/surfaceSeries.hpp"

namespace pfem {

template <int Dim>
class SurfaceBuilder {
public:
    /// Keeps the state and reads it until finish().
    explicit SurfaceBuilder(const State<Dim>& state) : state_(state) {}

    /// A line or polygon. `side`: in the fluid, in a solid, or (both) on a skin, where fields are those of all that
    /// touches it. What lies on both sides of an interface has points for each.
    void add(const EdgePoint* points, int n, Region side, int material);

    /// The surface with the fields interpolated on the edges; 0 where a field has no meaning.
    FieldSurface finish(const std::vector<NodalField<Dim>>& fields);

private:
    using Key = std::tuple<int, int, Region>;
    int indexOf(const EdgePoint& point, Region side);

    const State<Dim>& state_;
    std::map<Key, int> index_;
    std::vector<std::pair<EdgePoint, Region>> points_;
    FieldSurface surface_;
};

/// Fluid and solids along a plane.
template <int Dim>
FieldSurface cutSurface(const State<Dim>& state, const Plane<Dim>& plane, const std::vector<NodalField<Dim>>& fields);

/// Faces of cells of the fluid or of solids (`side`); `material` of each.
template <int Dim>
FieldSurface faceSurface(const State<Dim>& state, const std::vector<std::pair<Face<Dim>, int>>& facesAndMaterials,
                         Region side, const std::vector<NodalField<Dim>>& fields);

}  // namespace pfem
