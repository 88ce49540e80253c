#include "mesher/space/readGeometry.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "io/surfaceFile.hpp"
#include "mesher/curve.hpp"
#include "mesher/space/checkSurface.hpp"
#include "mesher/space/shapes.hpp"

namespace pfem {

namespace {

/// The entries of one shape.
class ShapeReader {
public:
    ShapeReader(const Dictionary& dict, double meshSize) : dict_(dict), meshSize_(meshSize) {}

    TriSurface box() const {
        const Vec<3> low = point("min"), high = point("max");
        if (!((high - low).minCoeff() > 0)) dict_.fatal("max", "'max' must be above 'min' in x, y and z");
        return boxSurface(low, high);
    }
    TriSurface cylinder() const {
        const double r = positive("radius");
        const auto [p1, p2] = ends();
        return coneSurface(p1, r, p2, r, segments(r));
    }
    TriSurface cone() const {
        const double r1 = number("radius1"), r2 = number("radius2");
        if (!(r1 >= 0 && r2 >= 0 && r1 + r2 > 0))
            dict_.fatal("radius1", "radius1 and radius2 must not be negative, and one of them positive");
        const auto [p1, p2] = ends();
        return coneSurface(p1, r1, p2, r2, segments(std::max(r1, r2)));
    }
    TriSurface sphere() const {
        const Vec<3> centre = point(dict_.found("centre") ? "centre" : "origin");
        const double r = positive("radius");
        return sphereSurface(centre, r, segments(r));
    }
    TriSurface plane() const {
        const Vec<3> centre = point(dict_.found("basePoint") ? "basePoint" : "point");
        return planeSurface(centre, normal(dict_.found("normalVector") ? "normalVector" : "normal"), positive("side"));
    }
    TriSurface disk() const {
        const double r = positive("radius");
        return diskSurface(point(dict_.found("centre") ? "centre" : "origin"), normal("normal"), r, segments(r));
    }
    TriSurface extrude() const {
        Points<2> polygon;
        for (const auto& c : dict_.get<std::vector<std::vector<double>>>("vertices"))
            polygon.push_back(toPoint<2>(dict_, "vertices", c));
        if (polygon.size() < 3) dict_.fatal("vertices", "A polygon needs three vertices at least");
        const Polygon outline = withArcs(polygon);
        checkPolygon(outline.points);
        if (dict_.found("axis")) return turned(outline);
        Vec<3> by(0, 0, dict_.found("direction") ? 0 : number("height"));
        if (dict_.found("direction")) by = point("direction");
        if (by[2] == 0) dict_.fatal(dict_.found("direction") ? "direction" : "height", "The height must not be 0");
        return extrudedSurface(outline, {0, 0, dict_.get("from", 0.0)}, by);
    }

private:
    Vec<3> point(const std::string& key) const { return toPoint<3>(dict_, key, dict_.get<std::vector<double>>(key)); }
    double number(const std::string& key) const { return dict_.get<double>(key); }
    double positive(const std::string& key) const {
        const double value = number(key);
        if (!(value > 0)) dict_.fatal(key, fmt::format("{} must be positive, not {:g}", key, value));
        return value;
    }
    Vec<3> normal(const std::string& key) const {
        Vec<3> n = point(key);
        if (!(n.norm() > 0)) dict_.fatal(key, "A normal must not be (0 0 0)");
        return n;
    }
    std::pair<Vec<3>, Vec<3>> ends() const {
        const Vec<3> p1 = point("point1"), p2 = point("point2");
        if (!((p2 - p1).norm() > 0)) dict_.fatal("point2", "point1 and point2 are one");
        return {p1, p2};
    }
    /// Of a circle with this radius: facets of half a mesh size, but no fewer than 24.
    int segments(double radius) const {
        const double wanted = meshSize_ > 0 ? 4 * std::numbers::pi * radius / meshSize_ : 48;
        const int n = dict_.get("segments", 4 * static_cast<int>(std::ceil(std::clamp(wanted, 24.0, 400.0) / 4)));
        if (n < 3 || n > 10000) dict_.fatal("segments", fmt::format("segments must be from 3 to 10000, not {}", n));
        return n;
    }
    void checkPolygon(const Points<2>& polygon) const {
        double area = 0;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            if (a == b) dict_.fatal("vertices", fmt::format("Two vertices are at ({:g} {:g})", a[0], a[1]));
            area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
        if (!(area > 0)) dict_.fatal("vertices", "The vertices run clockwise; write them counter-clockwise");
        try {
            polygonTriangles(polygon);
        } catch (const UserError& error) {
            dict_.fatal("vertices", error.what());
        }
    }
    /// edges (arc 1 2 (0.5 0.1)): circular arcs in pieces of half a mesh size, 24 at least.
    Polygon withArcs(const Points<2>& vertices) const {
        const int n = static_cast<int>(vertices.size());
        std::map<int, Vec<2>> through;  // by edge
        if (dict_.found("edges")) {
            TokenReader tokens = dict_.reader("edges");
            tokens.list([&] {
                const auto kind = tokens.read<std::string>();
                if (kind != "arc") dict_.fatal("edges", notValid(kind, "edge type", {"arc"}));
                const int from = tokens.read<int>(), to = tokens.read<int>();
                if (from < 0 || to < 0 || from >= n || to >= n || ((from + 1) % n != to && (to + 1) % n != from))
                    dict_.fatal("edges", fmt::format("arc {} {}: there is no edge between these vertices", from, to));
                through[(from + 1) % n == to ? from : to] =
                    toPoint<2>(dict_, "edges", tokens.read<std::vector<double>>());
            });
            tokens.end();
        }
        Polygon outline;
        for (int k = 0; k < n; ++k) {
            const auto &a = vertices[k], &b = vertices[(k + 1) % n];
            const auto arc = through.count(k) ? Curve::arc(a, through.at(k), b) : std::nullopt;
            int pieces = 1;
            if (arc) {
                const double length = arc->length();
                pieces = 24;  // of a whole circle 15 degrees each
                if (meshSize_ > 0) pieces = std::max(pieces, static_cast<int>(std::ceil(2 * length / meshSize_)));
            }
            for (int p = 0; p < std::min(pieces, 400); ++p) {
                outline.points.push_back(p == 0 ? a : arc->point(p / static_cast<double>(std::min(pieces, 400))));
                outline.edge.push_back(k);
            }
        }
        return outline;
    }
    TriSurface turned(const Polygon& outline) const {
        const Points<2>& polygon = outline.points;
        const std::string word = dict_.choice("axis", {"x", "y", "z"});
        const int axis = word[0] - 'x', out = axis == 0 ? 1 : 0;
        const double angle = dict_.get("angle", 360.0);
        if (!(angle > 0 && angle <= 360)) dict_.fatal("angle", fmt::format("angle is from 0 to 360, not {:g}", angle));
        double furthest = 0;
        for (const auto& p : polygon) {
            if (p[out] < 0)
                dict_.fatal(
                    "vertices",
                    fmt::format("({:g} {:g}) is at a negative distance from the axis; points are {}", p[0], p[1],
                                axis == 0   ? "(x r)"
                                : axis == 1 ? "(r y)"
                                            : "(r z)"));
            furthest = std::max(furthest, p[out]);
        }
        const int n = std::max(3, static_cast<int>(std::lround(segments(furthest) * angle / 360)));
        return turnedSurface(outline, axis, angle * std::numbers::pi / 180, n);
    }

    const Dictionary& dict_;
    double meshSize_;
};

using Reader = TriSurface (ShapeReader::*)() const;
const std::vector<std::pair<std::string, Reader>>& shapes() {
    static const std::vector<std::pair<std::string, Reader>> all = {
        {"box", &ShapeReader::box},        {"cylinder", &ShapeReader::cylinder}, {"cone", &ShapeReader::cone},
        {"sphere", &ShapeReader::sphere},  {"plane", &ShapeReader::plane},       {"disk", &ShapeReader::disk},
        {"extrude", &ShapeReader::extrude}};
    return all;
}

TriSurface readFile(const Dictionary& dict, const std::filesystem::path& caseFolder, Geometry& geometry) {
    std::filesystem::path file = dict.get("file", dict.keyword());
    if (!std::filesystem::exists(caseFolder / file)) file = std::filesystem::path("constant/triSurface") / file;
    file = caseFolder / file;
    if (!std::filesystem::is_regular_file(file))
        throw UserError("cannot find file \"" + file.string() + "\"", dict.where(dict.found("file") ? "file" : "type"));
    const double scale = dict.get("scale", 1.0);
    if (!(scale > 0)) dict.fatal("scale", fmt::format("scale must be positive, not {:g}", scale));
    geometry.scaled = dict.found("scale");
    geometry.file = file.string();
    TriSurface surface = readSurfaceFile(file);
    for (auto& x : surface.x) x *= scale;
    joinPoints(surface);
    if (dict.found("includedAngle")) splitRegions(surface, dict.get<double>("includedAngle"));
    return surface;
}

}  // namespace

Geometry readGeometry(const Dictionary& dict, const std::filesystem::path& caseFolder, double meshSize) {
    Geometry geometry;
    geometry.name = dict.get("name", dict.keyword());
    geometry.places = Places(dict);
    std::vector<std::string> types;
    for (const auto& [name, reader] : shapes()) types.push_back(name);
    types.emplace_back("triSurfaceMesh");
    const std::string type = dict.choice("type", types);
    if (type == "triSurfaceMesh") {
        geometry.surface = readFile(dict, caseFolder, geometry);
    } else {
        const ShapeReader reader(dict, meshSize);
        for (const auto& [name, read] : shapes())
            if (name == type) geometry.surface = (reader.*read)();
    }
    checkSurface(geometry);
    return geometry;
}

}  // namespace pfem
