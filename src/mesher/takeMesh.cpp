#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/vectors.hpp"
#include "mesher/draft.hpp"
#include "mesher/groupWalls.hpp"
#include "mesher/meshFile.hpp"

namespace pfem {

namespace {

/// The file's triangles of the description's bodies, as a draft.
class Taker {
public:
    Taker(const MeshDescription& description, const ForeignMesh& file)
        : description_(description), file_(file), draftNode_(file.x.size(), -1) {
        for (const auto& x : file.x) points_.push_back(description.scale * x);
    }

    MeshResult take() {
        joinPoints();
        MeshResult result;
        result.bodies.resize(description_.bodies.size());
        for (const auto type : {BodyType::fluid, BodyType::solid})  // solids last: theirs is the interface's velocity
            for (std::size_t b = 0; b < description_.bodies.size(); ++b)
                if (description_.bodies[b].type == type) result.bodies[b] = addBody(description_.bodies[b]);
        checkTouching(draft_, sides_, meanSize());
        for (std::size_t b = 0; b < description_.bodies.size(); ++b)
            addPatches(description_.bodies[b], result.bodies[b]);
        for (const auto& wall : description_.walls) addWall(wall);
        if (const auto left = std::count_if(file_.cells.begin(), file_.cells.end(),
                                            [&](const auto& t) { return t.group < 0 || !used_[t.group]; }))
            result.warnings.push_back(
                fmt::format("{} triangles of {} belong to no body and are left out", left, file_.file));
        result.state = finishMesh(std::move(draft_), description_, result.bodies);
        return result;
    }

private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw UserError("cannot take the mesh of \"" + file_.file + "\": " + message, {file_.file, line});
    }
    std::string place(int node) const { return fmt::format("({:g} {:g})", points_[node].x(), points_[node].y()); }

    int groupOf(int dimension, const std::string& name, const Location& where) const {
        const int group = file_.groupNamed(dimension, name);
        if (group < 0)
            throw UserError(
                notValid(name, dimension == 2 ? "group of triangles" : "group of edges", file_.groupNames(dimension)) +
                    "\nThey are those of " + file_.file + (file_.remark.empty() ? "" : "\n" + file_.remark),
                where);
        return group;
    }

    /// Points at one place are one: a geometry of touching pieces often has two of each.
    void joinPoints() {
        double shortest = std::numeric_limits<double>::max();
        const auto edge = [&](int a, int b) {
            const double length = (points_[a] - points_[b]).norm();
            if (length > 0) shortest = std::min(shortest, length);
        };
        for (const auto& t : file_.cells)
            for (int k = 0; k < 3; ++k) edge(t.nodes[k], t.nodes[(k + 1) % 3]);
        tolerance_ = 1e-6 * shortest;
        joined_.resize(points_.size());
        std::vector<int> order(points_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = joined_[i] = static_cast<int>(i);
        std::sort(order.begin(), order.end(), [&](int a, int b) { return points_[a].x() < points_[b].x(); });
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size() && points_[order[j]].x() - points_[order[i]].x() <= tolerance_;
                 ++j)
                if (joined_[order[j]] == order[j] &&
                    std::abs(points_[order[j]].y() - points_[order[i]].y()) <= tolerance_)
                    joined_[order[j]] = joined_[order[i]];
        used_.assign(file_.groups.size(), false);
    }

    /// The draft's node of a point of the file.
    int node(int point) {
        int& n = draftNode_[joined_[point]];
        if (n < 0) {
            n = static_cast<int>(draft_.x.size());
            draft_.x.push_back(points_[joined_[point]]);
            draft_.v.push_back(Vec<2>::Zero());
            draft_.h.push_back(0);
        }
        return n;
    }

    MeshedBody addBody(const Body& body) {
        const int group = groupOf(2, body.group, body.at(body.places.count("group") ? "group" : ""));
        used_[group] = true;
        Cells<2>& cells = body.type == BodyType::fluid ? draft_.mesh.fluid : draft_.mesh.solid;
        MeshedBody meshed;
        meshed.first = cells.size();
        const int material = materialIndex(draft_.mesh, body.material);
        std::map<int, std::pair<double, int>> lengths;  // of the edges at a node: sum and number
        for (const auto& t : file_.cells) {
            if (t.group != group) continue;
            std::array<int, 3> nodes = {node(t.nodes[0]), node(t.nodes[1]), node(t.nodes[2])};
            double twice = cross(draft_.x[nodes[1]] - draft_.x[nodes[0]], draft_.x[nodes[2]] - draft_.x[nodes[0]]);
            if (twice < 0) std::swap(nodes[1], nodes[2]), twice = -twice;
            double longest = 0;
            for (int k = 0; k < 3; ++k) {
                const double length = (draft_.x[nodes[k]] - draft_.x[nodes[(k + 1) % 3]]).norm();
                longest = std::max(longest, length);
                for (const int i : {nodes[k], nodes[(k + 1) % 3]}) lengths[i].first += length, ++lengths[i].second;
            }
            if (!(twice > 1e-6 * longest * longest))
                fail(t.line, "the triangle at " + place(t.nodes[0]) + " has no area");
            const BodyType type = body.type;
            for (int k = 0; k < 3; ++k)
                if (!sides_.emplace(Face<2>{nodes[k], nodes[(k + 1) % 3]}, type).second)
                    fail(t.line, "the triangle at " + place(t.nodes[0]) + " overlaps another one");
            cells.nodes.push_back({nodes[0], nodes[1], nodes[2]});
            cells.material.push_back(material);
            meshed.area += 0.5 * twice;
        }
        meshed.last = cells.size();
        double sum = 0;
        for (const auto& [i, length] : lengths) {
            const double h = body.meshSize > 0 ? body.meshSize : length.first / length.second;
            draft_.h[i] = draft_.h[i] > 0 ? std::min(draft_.h[i], h) : h;
            draft_.v[i] = body.velocityAt(draft_.x[i]);
            sum += h;
        }
        meshed.size = sum / static_cast<double>(lengths.size());
        const auto own = outlineOf(cells, meshed);
        for (const auto& [a, b] : own) meshed.perimeter += (draft_.x[a] - draft_.x[b]).norm();
        return meshed;
    }

    /// The edges of a body without a triangle of its own beyond.
    std::set<Face<2>> outlineOf(const Cells<2>& cells, const MeshedBody& meshed) const {
        std::set<Face<2>> edges;
        for (int c = meshed.first; c < meshed.last; ++c)
            for (int k = 0; k < 3; ++k) edges.insert({cells.nodes[c][k], cells.nodes[c][(k + 1) % 3]});
        std::set<Face<2>> outline;
        for (const auto& [a, b] : edges)
            if (!edges.count({b, a})) outline.insert({a, b});
        return outline;
    }

    double meanSize() const {
        double sum = 0;
        for (const double h : draft_.h) sum += h;
        return sum / static_cast<double>(draft_.h.size());
    }

    void addPatches(const Body& body, const MeshedBody& meshed) {
        if (body.edgeGroups.empty()) return;
        const auto own = outlineOf(body.type == BodyType::fluid ? draft_.mesh.fluid : draft_.mesh.solid, meshed);
        for (const auto& [name, groupName] : body.edgeGroups) {
            for (const auto& wall : description_.walls)
                if (wall.name == name)
                    throw UserError(fmt::format("patch '{}' of body '{}' has the name of a wall", name, body.name),
                                    body.at("patches"));
            const int group = groupOf(1, groupName, body.at("patches"));
            std::set<Face<2>> known;  // an edge of two entities may come twice
            for (const auto& e : file_.faces) {
                if (e.group != group) continue;
                const int a = draftNode_[joined_[e.nodes[0]]], b = draftNode_[joined_[e.nodes[1]]];
                const bool forward = own.count({a, b}) > 0;
                if (!forward && !own.count({b, a}))
                    fail(e.line, fmt::format("the edge at {} of patch '{}' is not on the outline of body '{}'",
                                             place(e.nodes[0]), name, body.name));
                const Face<2> face = forward ? Face<2>{a, b} : Face<2>{b, a};
                if (known.insert(face).second) patchNamed(draft_.mesh, name).faces.push_back(face);
            }
        }
    }

    void addWall(const Wall& wall) {
        Patch<2>& patch = patchNamed(draft_.mesh, wall.name);
        if (wall.group.empty()) {
            addPointWall(wall, sides_, meanSize(), draft_, patch);
            return;
        }
        const int group = groupOf(1, wall.group, wall.at(wall.places.count("group") ? "group" : ""));
        std::vector<WallEdge> edges;
        std::set<std::pair<int, int>> known;
        for (const auto& e : file_.faces) {
            if (e.group != group) continue;
            const int a = node(e.nodes[0]), b = node(e.nodes[1]);
            if (known.insert(std::minmax(a, b)).second) edges.push_back({{a, b}, e.line});
        }
        for (const auto& edge : edges)
            for (const int i : edge.nodes)
                if (draft_.h[i] == 0) draft_.h[i] = wall.meshSize > 0 ? wall.meshSize : meanSize();
        try {
            patch.faces = orientWall(edges, sides_);
        } catch (const WallBetween& error) {
            fail(error.line, "the edge at " +
                                 fmt::format("({:g} {:g})", draft_.x[error.node].x(), draft_.x[error.node].y()) +
                                 " of wall '" + wall.name + "' has bodies on both of its sides");
        }
    }

    const MeshDescription& description_;
    const ForeignMesh& file_;
    Points<2> points_;            // of the file, in metres
    double tolerance_ = 0;        // [m]
    std::vector<int> joined_;     // per point: the one that stands for it
    std::vector<int> draftNode_;  // per point: its node or -1
    std::vector<bool> used_;      // per group of the file
    Sides sides_;
    Draft draft_;
};

}  // namespace

MeshResult takeMesh(const MeshDescription& description, const ForeignMesh& file) {
    if (file.cells.empty()) throw UserError("there is no triangle in \"" + file.file + "\"", {file.file, 0});
    return Taker(description, file).take();
}

}  // namespace pfem
