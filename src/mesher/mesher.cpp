#include "mesher/mesher.hpp"

#include <algorithm>

#include "mesher/checks.hpp"
#include "mesher/draft.hpp"
#include "mesher/heldSizes.hpp"
#include "mesher/simplify.hpp"

namespace pfem {

namespace {

void addFaces(Patch<2>& patch, const std::vector<int>& nodes, bool forward) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        if (forward)
            patch.faces.push_back({nodes[i], nodes[i + 1]});
        else
            patch.faces.push_back({nodes[i + 1], nodes[i]});
    }
}

/// Fill one body and append its points and cells; returns where its cells are.
MeshedBody addBody(Draft& draft, const MeshDescription& description, int index, Region& region, const SizeField& size) {
    const Body& body = description.bodies[index];
    const auto triangles = body.pattern == Pattern::unstructured
                               ? fillUnstructured(region, size)
                               : fillPattern(region, body.pattern, patternCells(description, body));
    std::vector<int> global = region.boundaryNode;
    for (const int i : global) draft.v[i] = body.velocityAt(draft.x[i]);
    for (std::size_t i = region.nBoundary; i < region.x.size(); ++i) {
        global.push_back(static_cast<int>(draft.x.size()));
        draft.x.push_back(region.x[i]);
        draft.v.push_back(body.velocityAt(region.x[i]));
        draft.h.push_back(size.at(region.x[i], region.h));
    }
    Cells<2>& cells = body.type == BodyType::fluid ? draft.mesh.fluid : draft.mesh.solid;
    const int first = cells.size(), material = materialIndex(draft.mesh, body.material);
    for (const auto& t : triangles) {
        cells.nodes.push_back({global[t[0]], global[t[1]], global[t[2]]});
        cells.material.push_back(material);
    }
    return {first, cells.size(), region.area(), region.perimeter(), region.h};
}

/// Faces of the walls (none under a solid's named patch) and of the bodies' named patches.
void addPatches(Draft& draft, const MeshDescription& description, const Arrangement& arrangement,
                const BoundaryNodes& boundary) {
    for (const auto& wall : description.walls) patchNamed(draft.mesh, wall.name);
    for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
        const auto& uses = arrangement.pieces[p].uses;
        const bool underPatch = std::any_of(uses.begin(), uses.end(), [&](const PieceUse& use) {
            if (arrangement.isWall(use)) return false;
            const Body& body = description.bodies[use.outline];
            return body.type == BodyType::solid && !patchesOf(body, use.edge).empty();
        });
        for (const auto& use : uses) {
            if (arrangement.isWall(use)) {
                const auto& name = description.walls[use.outline - arrangement.nBodies].name;
                if (!underPatch) addFaces(patchNamed(draft.mesh, name), boundary.ofPiece[p], use.forward);
                continue;
            }
            const Body& body = description.bodies[use.outline];
            for (const auto& name : patchesOf(body, use.edge))
                addFaces(patchNamed(draft.mesh, name), boundary.ofPiece[p], use.forward);
        }
    }
    for (const auto& body : description.bodies)
        for (const auto& [name, edges] : body.patches)
            patchNamed(draft.mesh, name);  // without a face: the report says so
}

/// The outlines, cut where they touch, and their nodes.
struct Divided {
    Arrangement arrangement;
    SizeField size;
    BoundaryNodes boundary;

    explicit Divided(const MeshDescription& description, Arrangement all)
        : arrangement(std::move(all)), size(description, arrangement), boundary(divideBoundary(arrangement, size)) {}
};

/// Outlines with more points than the mesh can show are simplified, unless they would cross then.
Divided divideOutlines(const MeshDescription& description, double tolerance, std::vector<std::string>& warnings) {
    warnings = mergedPoints(description, tolerance);
    const Divided whole(description, arrange(description, tolerance));
    checkCrossings(description, whole.arrangement, whole.boundary);
    checkGaps(description, whole.arrangement, whole.boundary);
    const Simplified simplified = simplify(whole.arrangement, description, whole.size);
    Divided simple(description, simplified.arrangement);
    const bool taken = simplified.changed() && !crosses(simple.boundary);
    Divided result = whole;
    if (taken) result = std::move(simple);
    checkSpikes(description, result.arrangement, result.boundary);
    if (taken)
        for (auto& text : leftOutPoints(description, whole.arrangement, simplified.leftOut)) warnings.push_back(text);
    return result;
}

}  // namespace

MeshResult buildMesh(const MeshDescription& description) {
    checkDescription(description);
    checkCount(description);

    const double tolerance = mergeDistance(description);
    MeshResult result;
    const auto [arrangement, size, boundary] = divideOutlines(description, tolerance, result.warnings);

    const int nBodies = static_cast<int>(description.bodies.size());
    std::vector<Region> regions;
    for (int b = 0; b < nBodies; ++b) regions.push_back(regionOf(description, b, arrangement, boundary));
    for (auto& warning : checkRegions(description, arrangement, boundary, regions)) result.warnings.push_back(warning);

    Draft draft;
    draft.x = boundary.x;
    draft.h = boundary.h;
    draft.v.assign(draft.x.size(), Vec<2>::Zero());
    result.bodies.resize(nBodies);
    for (const auto type : {BodyType::fluid, BodyType::solid})  // solids last: theirs is the interface's velocity
        for (int b = 0; b < nBodies; ++b)
            if (description.bodies[b].type == type) result.bodies[b] = addBody(draft, description, b, regions[b], size);
    addPatches(draft, description, arrangement, boundary);
    result.state = finishMesh(std::move(draft), description, result.bodies);
    result.state.sizes = heldSizes(description);
    return result;
}

}  // namespace pfem
