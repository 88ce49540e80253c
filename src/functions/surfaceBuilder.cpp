#include "functions/surfaceBuilder.hpp"

#include "mesh/adjacency.hpp"

namespace pfem {

namespace {

/// From xx xy xz yy yz zz to VTK's xx yy zz xy yz xz.
std::vector<double> inOrderOfVtk(const std::vector<double>& v) {
    if (v.size() != 6) return v;
    return {v[0], v[3], v[5], v[1], v[4], v[2]};
}

}  // namespace

template <int Dim>
int SurfaceBuilder<Dim>::indexOf(const EdgePoint& point, Region side) {
    const auto [place, isNew] = index_.emplace(Key{point.a, point.b, side}, static_cast<int>(points_.size()));
    if (isNew) points_.emplace_back(point, side);
    return place->second;
}

template <int Dim>
void SurfaceBuilder<Dim>::add(const EdgePoint* points, int n, Region side, int material) {
    auto& cell = surface_.cells.emplace_back();
    for (int k = 0; k < n; ++k) cell.push_back(indexOf(points[k], side));
    surface_.material.push_back(material);
}

template <int Dim>
FieldSurface SurfaceBuilder<Dim>::finish(const std::vector<NodalField<Dim>>& fields) {
    const auto& nodes = state_.nodes;
    for (const auto& [point, side] : points_) {
        Vec<3> x = Vec<3>::Zero();
        x.head<Dim>() = valueAt(point, nodes.x);
        surface_.x.push_back(x);
    }
    const auto ofFluid = nodesIn<Dim>(state_.mesh.fluid.nodes, nodes.size());
    const auto ofSolid = nodesIn<Dim>(state_.mesh.solid.nodes, nodes.size());
    for (const auto& field : fields) {
        SurfaceField values{field.name, field.components, {}};
        for (const auto& [point, side] : points_) {
            const bool touched = (field.region == Region::fluid ? ofFluid : ofSolid)[point.a] != 0;
            const bool known = field.region == Region::both || (side == Region::both ? touched : side == field.region);
            std::vector<double> value(static_cast<std::size_t>(field.components), 0.0);
            if (known) {
                value = field.value(nodes, point.a);
                const auto other = field.value(nodes, point.b);
                for (std::size_t c = 0; c < value.size() && point.a != point.b; ++c)
                    value[c] = (1 - point.weight) * value[c] + point.weight * other[c];
            }
            for (const double v : inOrderOfVtk(value)) values.values.push_back(v);
        }
        surface_.fields.push_back(std::move(values));
    }
    surface_.materials = state_.mesh.materials;
    return std::move(surface_);
}

template <int Dim>
FieldSurface cutSurface(const State<Dim>& state, const Plane<Dim>& plane, const std::vector<NodalField<Dim>>& fields) {
    SurfaceBuilder<Dim> builder(state);
    const auto add = [&](const Cells<Dim>& cells, Region side) {
        for (const auto& piece : cutByPlane<Dim>(state.nodes.x, cells.nodes, plane))
            builder.add(piece.points.data(), piece.n, side, cells.material[piece.cell]);
    };
    add(state.mesh.fluid, Region::fluid);
    add(state.mesh.solid, Region::solid);
    return builder.finish(fields);
}

template <int Dim>
FieldSurface faceSurface(const State<Dim>& state, const std::vector<std::pair<Face<Dim>, int>>& facesAndMaterials,
                         Region side, const std::vector<NodalField<Dim>>& fields) {
    SurfaceBuilder<Dim> builder(state);
    for (const auto& [face, material] : facesAndMaterials) {
        std::array<EdgePoint, Dim> points;
        for (std::size_t k = 0; k < Dim; ++k) points[k] = {face[k], face[k], 0};
        builder.add(points.data(), Dim, side, material);
    }
    return builder.finish(fields);
}

#define PFEM_INSTANTIATE(D)                                                                                    \
    template class SurfaceBuilder<D>;                                                                          \
    template FieldSurface cutSurface<D>(const State<D>&, const Plane<D>&, const std::vector<NodalField<D>>&);  \
    template FieldSurface faceSurface<D>(const State<D>&, const std::vector<std::pair<Face<D>, int>>&, Region, \
                                         const std::vector<NodalField<D>>&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
