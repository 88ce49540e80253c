#include "mesher/heldSizes.hpp"

#include <algorithm>

#include "mesher/checks.hpp"

namespace pfem {

namespace {

SizePlace<2> placeOf(const Refinement& refinement) {
    SizePlace<2> place{refinement.meshSize, refinement.distance};
    const auto& x = refinement.points;
    if (refinement.box) {
        place.box = {x[0], x[1]};
        return place;
    }
    for (std::size_t k = 0; k + 1 < x.size(); ++k) place.faces.push_back({x[k], x[k + 1]});
    return place;
}

SizePlace<3> placeOf(const SpaceRefinement& refinement, const SpaceDescription& mesh) {
    using Type = SpaceRefinement::Type;
    if (refinement.type == Type::box) return {refinement.meshSize, 0, {{refinement.low, refinement.high}}};
    const auto& c = refinement.centre;
    if (refinement.type == Type::sphere) return {refinement.meshSize, refinement.radius, {}, {{c, c, c}}};
    SizePlace<3> place{refinement.meshSize, refinement.distance};
    for (const auto& wall : mesh.walls)
        if (wall.moving && wall.geometry == refinement.geometry) place.patch = wall.name;
    if (!place.patch.empty()) return place;
    const auto& surface = mesh.geometries[refinement.geometry].surface;
    for (const auto& [i, j, k] : surface.triangles) place.faces.push_back({surface.x[i], surface.x[j], surface.x[k]});
    return place;
}

}  // namespace

PlaceSizes<2> heldSizes(const MeshDescription& mesh) {
    PlaceSizes<2> sizes;
    if (!mesh.holdSizes) return sizes;
    for (const auto& body : mesh.bodies)
        if (body.type == BodyType::fluid) sizes.coarsest = std::max(sizes.coarsest, bodySize(mesh, body));
    for (const auto& refinement : mesh.refinements) sizes.places.push_back(placeOf(refinement));
    for (const auto& wall : mesh.walls)
        if (wall.meshSize > 0) sizes.places.push_back({wall.meshSize, 0, {}, {}, wall.name});
    return sizes;
}

PlaceSizes<3> heldSizes(const SpaceDescription& mesh) {
    PlaceSizes<3> sizes;
    if (!mesh.holdSizes) return sizes;
    for (const auto& body : mesh.bodies)
        if (body.type == BodyType::fluid) sizes.coarsest = std::max(sizes.coarsest, mesh.sizeOf(body));
    for (const auto& refinement : mesh.refinements) sizes.places.push_back(placeOf(refinement, mesh));
    return sizes;
}

}  // namespace pfem
