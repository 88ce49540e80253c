#include "mesher/readMeshDict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesher/fillLevel.hpp"
#include "mesher/sizes.hpp"

namespace pfem {

namespace {

/// edges ( arc 1 2 (0.5 0.1)  arc 2 3 (0.6 0.2) );
std::vector<ArcEdge> readArcs(const Dictionary& dict) {
    std::vector<ArcEdge> arcs;
    if (!dict.found("edges")) return arcs;
    TokenReader tokens = dict.reader("edges");
    tokens.list([&] {
        const auto kind = tokens.read<std::string>();
        if (kind != "arc") dict.fatal("edges", notValid(kind, "edge type", {"arc"}));
        ArcEdge arc;
        arc.from = tokens.read<int>();
        arc.to = tokens.read<int>();
        arc.through = toPoint<2>(dict, "edges", tokens.read<std::vector<double>>());
        arcs.push_back(arc);
    });
    tokens.end();
    return arcs;
}

void readOutline(const Dictionary& dict, const std::string& pointsKey, Outline& outline) {
    outline.name = dict.keyword();
    outline.places[""] = dict.where();
    for (const auto& key : dict.keys()) outline.places[key] = dict.where(key);
    TokenReader tokens = dict.reader(pointsKey);
    tokens.list([&] {
        outline.pointPlaces.push_back(tokens.peek().where());
        outline.points.push_back(toPoint<2>(dict, pointsKey, tokens.read<std::vector<double>>()));
    });
    tokens.end();
    outline.arcs = readArcs(dict);
    outline.meshSize = readSize(dict);
}

Body readBody(const Dictionary& dict, const std::vector<std::string>& materials) {
    Body body;
    readOutline(dict, "vertices", body);
    readNature<2>(dict, materials, body);
    const std::vector<std::string> patterns = {"unstructured", "checkerboard", "oneWay", "crossed"};
    const auto pattern = dict.choice("pattern", patterns, "unstructured");
    body.pattern = static_cast<Pattern>(std::find(patterns.begin(), patterns.end(), pattern) - patterns.begin());
    if (body.pattern != Pattern::unstructured && dict.found("cells")) {
        const auto cells = dict.get<std::vector<int>>("cells");
        if (cells.size() != 2 || cells[0] < 1 || cells[1] < 1)
            dict.fatal("cells", "cells must be two positive numbers: along the edges 0-1 and 1-2");
        body.cells = {cells[0], cells[1]};
    }
    body.holes = dict.get<std::vector<std::string>>("holes", {});
    const Dictionary patches = dict.subDictOrEmpty("patches");
    for (const auto& name : patches.keys()) {
        const Dictionary& patch = patches.subDict(name);
        for (const auto& pair : patch.get<std::vector<std::vector<int>>>("edges")) {
            if (pair.size() != 2) patch.fatal("edges", "An edge is named by its two vertices: edges ((3 0));");
            body.patches[name].push_back({pair[0], pair[1]});
        }
    }
    return body;
}

/// A group's name may be a number: that of a physical group without a name.
std::string readGroupName(const Dictionary& dict, const std::string& otherwise) {
    if (!dict.found("group")) return otherwise;
    TokenReader tokens = dict.reader("group");
    if (!tokens.peek().isNumber()) return dict.get<std::string>("group");
    return std::to_string(dict.get<std::int64_t>("group"));
}

/// Name, places for error messages, meshSize and group of a body or a wall of a mesh file.
void readGroup(const Dictionary& dict, Outline& outline, std::string& group) {
    outline.name = dict.keyword();
    outline.places[""] = dict.where();
    for (const auto& key : dict.keys()) outline.places[key] = dict.where(key);
    outline.meshSize = readSize(dict);
    group = readGroupName(dict, outline.name);
}

Body readFileBody(const Dictionary& dict, const std::vector<std::string>& materials) {
    Body body;
    readGroup(dict, body, body.group);
    readNature<2>(dict, materials, body);
    if (dict.found("vertices")) dict.fatal("vertices", "A body of a mesh file has no vertices but a group");
    const Dictionary patches = dict.subDictOrEmpty("patches");
    for (const auto& name : patches.keys()) body.edgeGroups[name] = readGroupName(patches.subDict(name), name);
    return body;
}

void readMeshFileEntries(const Dictionary& dict, double meshSize, MeshDescription& mesh) {
    mesh.meshFile = dict.get<std::string>("meshFile");
    mesh.meshFileAt = dict.where("meshFile");
    mesh.cellArray = dict.get<std::string>("cellArray", mesh.cellArray);
    mesh.scale = dict.get("scale", mesh.scale);
    if (!(mesh.scale > 0)) dict.fatal("scale", fmt::format("scale must be positive, not {:g}", mesh.scale));
    if (meshSize > 0) dict.fatal("meshFile", "-h has no meaning: the mesh is that of a file");
    if (dict.found("refinements")) dict.fatal("refinements", "The mesh of a file cannot be refined here");
}

/// refinements { splash { type box; min (0.4 0); max (0.6 0.2); meshSize 0.004; } }
Refinement readRefinement(const Dictionary& dict) {
    Refinement refinement;
    refinement.name = dict.keyword();
    refinement.where = dict.where();
    const std::string type = dict.choice("type", {"box", "sphere", "curve"});
    refinement.box = type == "box";
    refinement.meshSize = readSize(dict);
    if (refinement.meshSize == 0) dict.fatal("meshSize", "A refinement needs a meshSize");
    const auto point = [&](const std::string& key) {
        return toPoint<2>(dict, key, dict.get<std::vector<double>>(key));
    };
    if (refinement.box) {
        refinement.points = {point("min"), point("max")};
        if (!((refinement.points[1] - refinement.points[0]).minCoeff() > 0))
            dict.fatal("max", "'max' must be above and to the right of 'min'");
        return refinement;
    }
    if (type == "sphere") {
        const Vec<2> centre = point(dict.found("centre") ? "centre" : "origin");
        refinement.points = {centre, centre};
        refinement.distance = readRadius(dict);
        return refinement;
    }
    for (const auto& c : dict.get<std::vector<std::vector<double>>>("points"))
        refinement.points.push_back(toPoint<2>(dict, "points", c));
    if (refinement.points.size() < 2) dict.fatal("points", "A curve needs two points at least");
    for (std::size_t i = 0; i + 1 < refinement.points.size(); ++i)
        if (refinement.points[i] == refinement.points[i + 1])
            dict.fatal("points", "The curve has the same point twice");
    refinement.distance = dict.get("distance", 0.0);
    if (!(refinement.distance >= 0)) dict.fatal("distance", "distance must not be negative");
    return refinement;
}

/// Bodies, walls and refinements with the sizes of the dictionary.
MeshDescription readDescription(const Dictionary& dict, const std::vector<std::string>& materials, double meshSize) {
    MeshDescription mesh;
    const bool fromFile = dict.found("meshFile");
    if (fromFile) readMeshFileEntries(dict, meshSize, mesh);
    if (!fromFile) mesh.meshSize = readSize(dict);
    for (const auto& body : dict.dictList("bodies")) {
        if (fromFile) {
            mesh.bodies.push_back(readFileBody(body, materials));
            continue;
        }
        const Body whole = readBody(body, materials);
        if (body.found("level"))
            for (auto& pool : filledUpTo(body.get<double>("level"), whole)) mesh.bodies.push_back(std::move(pool));
        else
            mesh.bodies.push_back(whole);
    }
    if (mesh.bodies.empty()) dict.fatal("bodies", "There is no body to mesh");
    if (!fromFile && dict.found("refinements"))
        for (const auto& refinement : dict.dictList("refinements"))
            mesh.refinements.push_back(readRefinement(refinement));
    mesh.holdSizes = readHoldSizes(dict);
    if (!dict.found("walls")) return mesh;
    for (const auto& wallDict : dict.dictList("walls")) {
        Wall wall;
        if (fromFile && !wallDict.found("points")) {
            readGroup(wallDict, wall, wall.group);
        } else {
            readOutline(wallDict, "points", wall);
            wall.closed = wallDict.get("closed", false);
        }
        wall.moving = wallDict.get("moving", false);
        mesh.walls.push_back(wall);
    }
    return mesh;
}

}  // namespace

MeshDescription readMeshDict(const Dictionary& dict, const std::vector<std::string>& materials, double meshSize) {
    MeshDescription mesh = readDescription(dict, materials, meshSize);
    if (meshSize <= 0) return mesh;
    if (mesh.meshSize > 0) scaleSizes(meshSize / mesh.meshSize, mesh);
    mesh.meshSize = meshSize;
    return mesh;
}

}  // namespace pfem
