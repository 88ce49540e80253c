#include "mesher/space/readSpaceDict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesher/meshFile.hpp"
#include "mesher/sizes.hpp"
#include "mesher/space/readGeometry.hpp"

namespace pfem {

namespace {

/// A word, or a list of words.
std::vector<std::string> readNames(const Dictionary& dict, const std::string& key) {
    if (!dict.found(key)) return {};
    TokenReader tokens = dict.reader(key);
    if (tokens.peek().isWord()) return {dict.get<std::string>(key)};
    return dict.get<std::vector<std::string>>(key);
}

class SpaceReader {
public:
    SpaceReader(const Dictionary& dict, const std::vector<std::string>& materials, const std::filesystem::path& folder)
        : dict_(dict), materials_(materials), folder_(folder) {}

    SpaceDescription read(double meshSize) {
        mesh_.places = Places(dict_);
        const double ofDict = readSize(dict_);
        mesh_.meshSize = meshSize > 0 ? meshSize : ofDict;
        if (dict_.found("meshFile")) readMeshFileEntries(meshSize);
        if (dict_.found("geometry"))
            for (const auto& shape : dict_.dictList("geometry")) addGeometry(shape);
        for (const auto& body : dict_.dictList("bodies")) mesh_.bodies.push_back(readBody(body));
        if (mesh_.bodies.empty()) dict_.fatal("bodies", "There is no body to mesh");
        if (dict_.found("walls"))
            for (const auto& wall : dict_.dictList("walls")) mesh_.walls.push_back(readWall(wall));
        if (dict_.found("refinements"))
            for (const auto& place : dict_.dictList("refinements")) mesh_.refinements.push_back(readRefinement(place));
        mesh_.holdSizes = readHoldSizes(dict_);
        if (meshSize > 0 && ofDict > 0) scaleSizes(meshSize / ofDict, mesh_);
        return std::move(mesh_);
    }

private:
    bool fromFile() const { return !mesh_.meshFile.empty(); }

    void readMeshFileEntries(double meshSize) {
        mesh_.meshFile = dict_.get<std::string>("meshFile");
        mesh_.cellArray = dict_.get<std::string>("cellArray", mesh_.cellArray);
        mesh_.scale = dict_.get("scale", mesh_.scale);
        if (!(mesh_.scale > 0)) dict_.fatal("scale", fmt::format("scale must be positive, not {:g}", mesh_.scale));
        if (meshSize > 0) dict_.fatal("meshFile", "-h has no meaning: the mesh is that of a file");
        if (dict_.found("refinements")) dict_.fatal("refinements", "The mesh of a file cannot be refined here");
    }

    /// A group's name may be a number: that of a physical group without a name.
    static std::string readGroup(const Dictionary& dict) {
        if (!dict.found("group")) return dict.keyword();
        TokenReader tokens = dict.reader("group");
        if (!tokens.peek().isNumber()) return dict.get<std::string>("group");
        return std::to_string(dict.get<std::int64_t>("group"));
    }

    int addGeometry(const Dictionary& shape) {
        Geometry geometry = readGeometry(shape, folder_, mesh_.meshSize);
        if (mesh_.geometryNamed(geometry.name) >= 0)
            throw UserError(fmt::format("There are two shapes '{}'", geometry.name), shape.where());
        mesh_.geometries.push_back(std::move(geometry));
        return static_cast<int>(mesh_.geometries.size()) - 1;
    }

    int geometryIndex(const Dictionary& dict, const std::string& key, const std::string& name) const {
        const int g = mesh_.geometryNamed(name);
        if (g < 0) dict.fatal(key, notValid(name, "geometry", mesh_.geometryNames()));
        return g;
    }

    /// Shapes by their names, or one shape here: geometry { type box; ... }
    std::vector<int> readShapes(const Dictionary& dict, const std::string& key) {
        if (dict.isDict(key)) {
            const int g = addGeometry(dict.subDict(key));
            auto& name = mesh_.geometries[g].name;
            if (name == key) name = dict.keyword();
            return {g};
        }
        std::vector<int> shapes;
        for (const auto& name : readNames(dict, key)) shapes.push_back(geometryIndex(dict, key, name));
        return shapes;
    }

    SpaceBody readBody(const Dictionary& dict) {
        SpaceBody body;
        body.name = dict.keyword();
        body.places = Places(dict);
        body.meshSize = readSize(dict);
        readNature<3>(dict, materials_, body);
        if (dict.found("vertices"))
            dict.fatal("vertices", "A body in space is made of `geometry`; a polygon is extruded there (type extrude)");
        const Dictionary patches = dict.subDictOrEmpty("patches");
        if (fromFile()) {
            body.group = readGroup(dict);
            for (const auto& name : patches.keys()) body.faceGroups[name] = readGroup(patches.subDict(name));
            return body;
        }
        body.space.all = readShapes(dict, "geometry");
        if (body.space.all.empty()) dict.fatal("geometry", fmt::format("Body '{}' needs a geometry", body.name));
        body.space.within = readShapes(dict, "intersect");
        body.space.without = readShapes(dict, "subtract");
        for (const auto& name : patches.keys()) body.patches[name] = readSelection(patches.subDict(name), body);
        return body;
    }

    /// faces (zMin pier.side pier); box (0 0 0) (1 1 0);
    FaceSelection readSelection(const Dictionary& dict, const SpaceBody& body) {
        FaceSelection selection;
        selection.places = Places(dict);
        for (const auto& name : readNames(dict, "faces")) addRegion(dict, body, name, selection);
        if (dict.found("box")) {
            TokenReader tokens = dict.reader("box");
            const Vec<3> low = toPoint<3>(dict, "box", tokens.read<std::vector<double>>());
            const Vec<3> high = toPoint<3>(dict, "box", tokens.read<std::vector<double>>());
            tokens.end();
            if (!((high - low).minCoeff() >= 0)) dict.fatal("box", "The second point of a box is above the first one");
            selection.box = {low, high};
        }
        if (selection.regions.empty() && !selection.box)
            dict.fatal("faces", "A patch is chosen by faces (...) of the shapes, or by box (x y z) (x y z)");
        return selection;
    }

    void addRegion(const Dictionary& dict, const SpaceBody& body, const std::string& name, FaceSelection& selection) {
        std::vector<std::string> valid;
        std::vector<int> shapes = body.space.all;
        for (const auto* list : {&body.space.within, &body.space.without})
            shapes.insert(shapes.end(), list->begin(), list->end());
        bool found = false;
        for (const int g : shapes) {
            const auto& geometry = mesh_.geometries[g];
            valid.push_back(geometry.name);
            if (name == geometry.name) selection.regions.emplace_back(g, -1), found = true;
            for (std::size_t r = 0; r < geometry.surface.regions.size(); ++r) {
                const auto &region = geometry.surface.regions[r], full = geometry.name + "." + region;
                valid.push_back(shapes.size() > 1 ? full : region);
                if (name == region || name == full)
                    selection.regions.emplace_back(g, static_cast<int>(r)), found = true;
            }
        }
        if (!found) dict.fatal("faces", notValid(name, "face of body '" + body.name + "'", valid));
    }

    SpaceWall readWall(const Dictionary& dict) {
        SpaceWall wall;
        wall.name = dict.keyword();
        wall.places = Places(dict);
        if (dict.found("points"))
            dict.fatal("points", "A wall in space is made of `geometry`; its faces without wall are open (...)");
        wall.moving = dict.get("moving", false);
        if (fromFile() && !dict.found("geometry")) {
            wall.group = readGroup(dict);
            wall.side = readSide(dict);
            return wall;
        }
        const auto shapes = readShapes(dict, "geometry");
        if (shapes.size() != 1) dict.fatal("geometry", fmt::format("Wall '{}' needs one geometry", wall.name));
        wall.geometry = shapes.front();
        const auto& surface = mesh_.geometries[wall.geometry].surface;
        wall.open.assign(surface.regions.size(), false);
        for (const auto& name : readNames(dict, "open")) {
            const int region = surface.regionNamed(name);
            if (region < 0) dict.fatal("open", notValid(name, "face of wall '" + wall.name + "'", surface.regions));
            wall.open[region] = true;
        }
        wall.side = readSide(dict);
        return wall;
    }

    static WallSide readSide(const Dictionary& dict) {
        const std::vector<std::string> sides = {"automatic", "inside", "outside"};
        const auto side = dict.choice("fluid", sides, "automatic");
        return static_cast<WallSide>(std::find(sides.begin(), sides.end(), side) - sides.begin());
    }

    SpaceRefinement readRefinement(const Dictionary& dict) {
        SpaceRefinement place;
        place.name = dict.keyword();
        place.places = Places(dict);
        const std::vector<std::string> types = {"box", "sphere", "surface"};
        const auto type = dict.choice("type", types);
        place.type = static_cast<SpaceRefinement::Type>(std::find(types.begin(), types.end(), type) - types.begin());
        place.meshSize = readSize(dict);
        if (place.meshSize == 0) dict.fatal("meshSize", "A refinement needs a meshSize");
        const auto point = [&](const std::string& key) {
            return toPoint<3>(dict, key, dict.get<std::vector<double>>(key));
        };
        if (place.type == SpaceRefinement::Type::box) {
            place.low = point("min");
            place.high = point("max");
            if (!((place.high - place.low).minCoeff() > 0))
                dict.fatal("max", "'max' must be above 'min' in x, y and z");
        } else if (place.type == SpaceRefinement::Type::sphere) {
            place.centre = point(dict.found("centre") ? "centre" : "origin");
            place.radius = readRadius(dict);
        } else {
            const auto shapes = readShapes(dict, "geometry");
            if (shapes.size() != 1) dict.fatal("geometry", "A refinement round a surface needs one geometry");
            place.geometry = shapes.front();
            place.distance = dict.get("distance", 0.0);
            if (!(place.distance >= 0)) dict.fatal("distance", "distance must not be negative");
        }
        return place;
    }

    const Dictionary& dict_;
    const std::vector<std::string>& materials_;
    const std::filesystem::path& folder_;
    SpaceDescription mesh_;
};

}  // namespace

int meshDimension(const Dictionary& dict, const std::filesystem::path& caseFolder) {
    if (dict.found("dimension")) {
        const int dimension = dict.get<int>("dimension");
        if (dimension != 2 && dimension != 3)
            dict.fatal("dimension", fmt::format("dimension must be 2 or 3, not {}", dimension));
        return dimension;
    }
    if (dict.found("meshFile")) return holdsTetrahedra(caseFolder / dict.get<std::string>("meshFile")) ? 3 : 2;
    if (!dict.found("bodies")) return 2;
    if (dict.found("geometry")) return 3;
    for (const auto& body : dict.dictList("bodies"))
        if (body.found("geometry")) return 3;
    return 2;
}

SpaceDescription readSpaceDict(const Dictionary& dict, const std::vector<std::string>& materials,
                               const std::filesystem::path& caseFolder, double meshSize) {
    return SpaceReader(dict, materials, caseFolder).read(meshSize);
}

}  // namespace pfem
