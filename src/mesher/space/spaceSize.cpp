#include <algorithm>
#include <memory>

#include "mesher/space/spaceDraft.hpp"
#include "state/placeSizes.hpp"

namespace pfem {

namespace {

/// A place of finer mesh: how far away is x? 0 within.
struct FinePlace {
    double size;
    std::function<double(const Vec<3>&, double)> away;  // at most the second argument
};

std::shared_ptr<BoxTree> treeOf(const TriSurface& surface) {
    std::vector<BoxTree::Triangle> triangles;
    for (const auto& [a, b, c] : surface.triangles) triangles.push_back({surface.x[a], surface.x[b], surface.x[c]});
    return std::make_shared<BoxTree>(std::move(triangles));
}

FinePlace placeOf(const SpaceRefinement& r, const SpaceDescription& description) {
    switch (r.type) {
        case SpaceRefinement::Type::box:
            return {r.meshSize, [r](const Vec<3>& x, double) { return distanceToBox<3>(x, r.low, r.high); }};
        case SpaceRefinement::Type::sphere:
            return {r.meshSize,
                    [r](const Vec<3>& x, double) { return std::max(0.0, (x - r.centre).norm() - r.radius); }};
        default: {
            const auto tree = treeOf(description.geometries[r.geometry].surface);
            return {r.meshSize, [r, tree](const Vec<3>& x, double most) {
                        return std::max(0.0, tree->nearest(x, most + r.distance).first - r.distance);
                    }};
        }
    }
}

/// A body with a finer mesh than others: its surface. Within it its own size holds anyway.
std::vector<FinePlace> placesOf(const SpaceBody& body, double size, const SpaceDescription& description) {
    std::vector<FinePlace> places;
    for (const auto* list : {&body.space.all, &body.space.within})
        for (const int g : *list) {
            const auto tree = treeOf(description.geometries[g].surface);
            places.push_back({size, [tree](const Vec<3>& x, double most) { return tree->nearest(x, most).first; }});
        }
    return places;
}

}  // namespace

SizeAt sizeField(const SpaceDescription& description, const SpaceDomain&) {
    std::vector<double> ofBody;
    double largest = 0, smallest = description.sizeOf(description.bodies.front());
    for (const auto& body : description.bodies) {
        ofBody.push_back(description.sizeOf(body));
        largest = std::max(largest, ofBody.back());
        smallest = std::min(smallest, ofBody.back());
    }
    std::vector<FinePlace> places;
    for (std::size_t b = 0; b < ofBody.size(); ++b)
        if (ofBody[b] < largest)
            for (auto& place : placesOf(description.bodies[b], ofBody[b], description)) places.push_back(place);
    for (const auto& r : description.refinements) places.push_back(placeOf(r, description));
    std::sort(places.begin(), places.end(), [](const FinePlace& a, const FinePlace& b) { return a.size < b.size; });
    return [ofBody, largest, places](const Vec<3>& x, std::pair<int, int> labels) {
        double size = largest;
        for (const int label : {labels.first, labels.second})
            if (label > 0) size = std::min(size, ofBody[static_cast<std::size_t>(label) - 1]);
        for (const auto& place : places) {
            if (place.size >= size) break;
            size = std::min(size, place.size + sizeGrowth * place.away(x, (size - place.size) / sizeGrowth));
        }
        return size;
    };
}

}  // namespace pfem
