#include "mesher/space/spaceMesher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mesh/simplex.hpp"
#include "mesher/heldSizes.hpp"
#include "mesher/space/checkSpace.hpp"
#include "mesher/space/featureLines.hpp"
#include "mesher/space/joinSurfaces.hpp"
#include "mesher/space/spaceDraft.hpp"

namespace pfem {

namespace {

double smallestSize(const SpaceDescription& description) {
    double smallest = std::numeric_limits<double>::max();
    for (const auto& body : description.bodies) smallest = std::min(smallest, description.sizeOf(body));
    return smallest;
}

/// The surfaces that bodies are made of, and the bodies with their numbers.
SpaceDomain domainOf(const SpaceDescription& description) {
    std::vector<int> number(description.geometries.size(), -1);
    std::vector<TriSurface> surfaces;
    const auto renumbered = [&](const std::vector<int>& list) {
        std::vector<int> result;
        for (const int g : list) {
            if (number[g] < 0) {
                number[g] = static_cast<int>(surfaces.size());
                surfaces.push_back(description.geometries[g].surface);
            }
            result.push_back(number[g]);
        }
        return result;
    };
    std::vector<BodySpace> bodies;
    for (const auto& body : description.bodies)
        bodies.push_back({renumbered(body.space.all), renumbered(body.space.within), renumbered(body.space.without)});
    return SpaceDomain(std::move(surfaces), std::move(bodies));
}

/// The wanted size at each node: the least of its cells' bodies.
std::vector<double> sizesAt(const Tetrahedra& cells, const SizeAt& size) {
    std::vector<double> h(cells.x.size(), 0);
    for (std::size_t c = 0; c < cells.cells.size(); ++c)
        for (const int i : cells.cells[c]) {
            const double wanted = size(cells.x[i], {cells.label[c], cells.label[c]});
            if (h[i] == 0 || wanted < h[i]) h[i] = wanted;
        }
    return h;
}

/// Fill the bodies; what takes far more nodes than their volumes, surfaces and edges ask for is refused.
Tetrahedra fill(const SpaceDescription& description, const SpaceDomain& domain, const std::vector<Points<3>>& lines,
                const SizeAt& size) {
    double h = smallestSize(description), nodes = 0;
    for (const auto& place : description.refinements) h = std::min(h, place.meshSize);
    for (const auto& surface : domain.surfaces())
        nodes += volumeInside(surface) / (h * h * h) + areaOf(surface) / (h * h);
    for (const auto& line : lines)
        for (std::size_t k = 0; k + 1 < line.size(); ++k) nodes += 1 + (line[k + 1] - line[k]).norm() / h;
    try {
        return fillBodies(domain, lines, size, 20 * nodes + 2000);
    } catch (const UserError& error) {
        throw UserError(error.what(), description.places.of("bodies"));
    }
}

}  // namespace

SpaceMeshResult buildSpaceMesh(const SpaceDescription& asked) {
    auto warnings = checkSpace(asked);
    SpaceDescription description = asked;
    joinSurfaces(description, smallestSize(asked));
    checkGaps(description, smallestSize(asked));
    const SpaceDomain domain = domainOf(description);
    const SizeAt size = sizeField(description, domain);
    const auto lines = featureLines(domain, smallestSize(description));
    const Tetrahedra cells = fill(description, domain, lines, size);
    checkFilled(description, domain, cells);
    SpaceMeshResult result = finishSpaceMesh(description, cells, sizesAt(cells, size));
    result.state.sizes = heldSizes(description);
    result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
    return result;
}

}  // namespace pfem
