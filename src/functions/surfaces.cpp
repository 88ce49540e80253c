#include "functions/surfaces.hpp"

#include "dictionary/function1.hpp"
#include "functions/sampling.hpp"
#include "functions/sensors.hpp"
#include "functions/surfaceBuilder.hpp"
#include "solver/setup.hpp"

namespace pfem {

namespace {

template <int Dim>
FieldSurface freeSurfaceOf(const State<Dim>& state, const std::vector<PatchKind>& kinds,
                           const std::vector<NodalField<Dim>>& fields) {
    std::vector<std::pair<Face<Dim>, int>> faces;
    const auto topology = makeTopology<Dim>(state.mesh, kinds, state.nodes.x, state.nodes.wall);
    for (const auto& face : topology.faces)
        if (face.kind == FaceKind::freeSurface) faces.emplace_back(face.nodes, state.mesh.fluid.material[face.cell]);
    return faceSurface<Dim>(state, faces, Region::fluid, fields);
}

template <int Dim>
FieldSurface skinOf(const State<Dim>& state, const std::vector<NodalField<Dim>>& fields) {
    std::vector<std::pair<Face<Dim>, int>> faces;
    const auto& solid = state.mesh.solid;
    for (const auto& face : boundaryFaces<Dim>(solid.nodes, nodeToCells<Dim>(solid.nodes, state.nodes.size())))
        faces.emplace_back(face.nodes, solid.material[face.cell]);
    return faceSurface<Dim>(state, faces, Region::both, fields);
}

}  // namespace

template <int Dim>
Plane<Dim> planeOf(const Dictionary& dict, const std::string& key, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& normal) {
    if (!(normal.norm() > 0)) dict.fatal(key, "the normal has no length");
    if (Dim == 2) demandPlane(dict, key, normal[2]);
    warnOutOfPlane<Dim>(dict, key, {point});
    return {point.head<Dim>(), normal.head<Dim>().normalized()};
}

template <int Dim>
Surfaces<Dim>::Surfaces(const Dictionary& dict, const FunctionContext<Dim>& context) : context_(context) {
    readEntries(dict, entries_);
    fields_ = nodalFields<Dim>(dict, entries_.fields);
    for (const auto& plane : entries_.planes) {
        if (plane.size() != 2) dict.fatal("planes", "a plane is a point and a normal: planes (((0.5 0 0) (1 0 0)));");
        planes_.push_back(planeOf<Dim>(dict, "planes", plane[0], plane[1]));
    }
    if (planes_.empty() && !entries_.freeSurface && !entries_.solidSkin)
        dict.fatal("planes", "which surfaces? planes (((0.5 0 0) (1 0 0))); or freeSurface yes; or solidSkin yes;");
}

template <int Dim>
void Surfaces<Dim>::start(const State<Dim>& state) {
    if (entries_.freeSurface) kinds_ = readProblem<Dim>(Case(context_.root), state, nullptr).conditions.kind;
    series_.clear();
    const auto begin = [&](const std::string& name) {
        series_.emplace_back(context_.folder.parent_path(), name, context_.resumeAt);
    };
    for (std::size_t k = 0; k < planes_.size(); ++k) begin("plane" + std::to_string(k));
    if (entries_.freeSurface) begin("freeSurface");
    if (entries_.solidSkin) begin("solidSkin");
}

template <int Dim>
void Surfaces<Dim>::execute(const State<Dim>& state) {
    const double time = state.time.value;
    std::size_t k = 0;
    for (const auto& plane : planes_) series_[k++].add(cutSurface<Dim>(state, plane, fields_), time);
    if (entries_.freeSurface) series_[k++].add(freeSurfaceOf<Dim>(state, kinds_, fields_), time);
    if (entries_.solidSkin) series_[k++].add(skinOf<Dim>(state, fields_), time);
}

#define PFEM_INSTANTIATE(D)                                                                     \
    template Plane<D> planeOf<D>(const Dictionary&, const std::string&, const Eigen::Vector3d&, \
                                 const Eigen::Vector3d&);                                       \
    template class Surfaces<D>;
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
