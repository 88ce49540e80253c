#include "mesher/space/checkSpace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/simplex.hpp"
#include "mesher/space/checkSurface.hpp"

namespace pfem {

namespace {

void checkClosed(const SpaceDescription& description, const SpaceBody& body) {
    for (const auto* list : {&body.space.all, &body.space.within, &body.space.without})
        for (const int g : *list) {
            const auto& geometry = description.geometries[g];
            if (geometry.closed) continue;
            const auto edges = freeEdges(geometry.surface);
            const auto& [a, b] = edges.front();
            throw UserError(
                fmt::format(
                    "The surface '{}'{} is not closed: body '{}' would leak. {} edges have one triangle only, the "
                    "first from {} to {}",
                    geometry.name, geometry.file.empty() ? "" : " of \"" + geometry.file + "\"", body.name,
                    edges.size(), placeOf(a), placeOf(b)),
                body.places.of("geometry"));
        }
}

/// The box of a body [m].
std::pair<Vec<3>, Vec<3>> boxOf(const SpaceDescription& description, const SpaceBody& body) {
    Vec<3> low = description.geometries[body.space.all.front()].surface.low(), high = low;
    for (const int g : body.space.all) {
        low = low.cwiseMin(description.geometries[g].surface.low()).eval();
        high = high.cwiseMax(description.geometries[g].surface.high()).eval();
    }
    return {low, high};
}

double volumeOf(const SpaceDescription& description, const SpaceBody& body) {
    double volume = 0;
    for (const int g : body.space.all) volume += volumeInside(description.geometries[g].surface);
    return volume;
}

double surfaceOf(const SpaceDescription& description, const SpaceBody& body) {
    double area = 0;
    for (const int g : body.space.all) area += areaOf(description.geometries[g].surface);
    return area;
}

void checkSize(const SpaceDescription& description, const SpaceBody& body) {
    const double h = description.sizeOf(body);
    if (!(h > 0))
        throw UserError(fmt::format("Body '{}' has no meshSize, and the dictionary has no default one", body.name),
                        body.places.of());
    const auto [low, high] = boxOf(description, body);
    const double width = (high - low).minCoeff();
    if (h > width)
        throw UserError(fmt::format("meshSize {:g} is larger than body '{}' ({:.3g} wide)", h, body.name, width),
                        body.places.of("meshSize"));
}

}  // namespace

std::vector<std::string> checkSpace(const SpaceDescription& description) {
    if (description.bodies.empty()) throw UserError("There is no body to mesh", description.places.of("bodies"));
    std::vector<std::string> warnings;
    std::set<std::string> walls;
    for (const auto& wall : description.walls) walls.insert(wall.name);
    double count = 0;
    for (const auto& body : description.bodies) {
        checkClosed(description, body);
        checkSize(description, body);
        const double h = description.sizeOf(body);
        count += volumeOf(description, body) / (0.12 * h * h * h) + surfaceOf(description, body) / (0.1 * h * h);
        for (const auto& [name, selection] : body.patches)
            if (walls.count(name))
                throw UserError(fmt::format("patch '{}' of body '{}' has the name of a wall", name, body.name),
                                selection.places.of());
    }
    if (count > 2e7)
        throw UserError(
            fmt::format("The mesh would have about {:.1e} tetrahedra. Check meshSize and the units (metres).", count),
            description.places.of("meshSize"));
    for (const auto& geometry : description.geometries) {
        if (geometry.file.empty() || geometry.scaled) continue;
        const Vec<3> extent = geometry.surface.high() - geometry.surface.low();
        if (extent.maxCoeff() > 100)
            warnings.push_back(fmt::format(
                "{}: '{}' is {:g} m long, and water would fall {:.3g} s through it: is \"{}\" in millimetres (scale "
                "0.001;)?",
                toString(geometry.places.of()), geometry.name, extent.maxCoeff(),
                std::sqrt(2 * extent.maxCoeff() / 9.81), geometry.file));
    }
    return warnings;
}

void checkFilled(const SpaceDescription& description, const SpaceDomain& domain, const Tetrahedra& cells) {
    std::vector<int> count(description.bodies.size(), 0);
    for (std::size_t c = 0; c < cells.cells.size(); ++c) {
        const int own = cells.label[c] - 1;
        ++count[own];
        const Vec<3> x = simplexCentroid<3>(cells.x, cells.cells[c]);
        for (int b = own + 1; b < static_cast<int>(count.size()); ++b)
            if (domain.isIn(b, x) && domain.isIn(own, x))
                throw UserError(
                    fmt::format("The bodies '{}' and '{}' lie in each other at {}: subtract (...) cuts one out "
                                "of the other",
                                description.bodies[own].name, description.bodies[b].name, placeOf(x)),
                    description.bodies[own].places.of());
    }
    for (std::size_t b = 0; b < count.size(); ++b)
        if (count[b] == 0)
            throw UserError(
                fmt::format("Nothing is left of body '{}': has all of it been cut away?", description.bodies[b].name),
                description.bodies[b].places.of());
}

}  // namespace pfem
