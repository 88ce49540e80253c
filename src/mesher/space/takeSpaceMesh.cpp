#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh/simplex.hpp"
#include "mesher/space/checkSurface.hpp"
#include "mesher/space/spaceDraft.hpp"

namespace pfem {

namespace {

/// The file's tetrahedra of the description's bodies.
class SpaceTaker {
public:
    SpaceTaker(SpaceDescription& description, const ForeignMeshOf<3>& file)
        : description_(description), file_(file), number_(file.x.size(), -1) {
        for (const auto& x : file.x) points_.push_back(description.scale * x);
        joinPoints();
    }

    SpaceMeshResult take() {
        for (std::size_t b = 0; b < description_.bodies.size(); ++b) addBody(static_cast<int>(b));
        for (auto& body : description_.bodies)
            for (const auto& [name, group] : body.faceGroups)
                body.patches[name].regions = {{addGeometry(name, group, body.places.of("patches")), -1}};
        for (auto& wall : description_.walls) {
            if (wall.geometry >= 0) continue;
            wall.geometry = addGeometry(wall.name, wall.group, wall.places.of("group"));
            wall.open.assign(description_.geometries[wall.geometry].surface.regions.size(), false);
        }
        std::vector<double> h(cells_.x.size());
        for (std::size_t i = 0; i < h.size(); ++i) h[i] = lengths_[i].first / lengths_[i].second;
        SpaceMeshResult result = finishSpaceMesh(description_, cells_, h);
        const auto left = static_cast<std::ptrdiff_t>(file_.cells.size() - cells_.cells.size());
        if (left > 0)
            result.warnings.push_back(
                fmt::format("{} tetrahedra of {} belong to no body and are left out", left, file_.file));
        setSizes(result);
        return result;
    }

private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw UserError("cannot take the mesh of \"" + file_.file + "\": " + message, {file_.file, line});
    }

    int groupOf(int dimension, const std::string& name, const Location& where) const {
        const int group = file_.groupNamed(dimension, name);
        if (group < 0)
            throw UserError(notValid(name, dimension == 3 ? "group of tetrahedra" : "group of triangles",
                                     file_.groupNames(dimension)) +
                                "\nThey are those of " + file_.file + (file_.remark.empty() ? "" : "\n" + file_.remark),
                            where);
        return group;
    }

    /// Points at one place are one: a geometry of touching pieces often has two of each.
    void joinPoints() {
        double shortest = std::numeric_limits<double>::max();
        for (const auto& cell : file_.cells)
            for (int k = 0; k < 4; ++k)
                for (int l = k + 1; l < 4; ++l) {
                    const double length = (points_[cell.nodes[k]] - points_[cell.nodes[l]]).norm();
                    if (length > 0) shortest = std::min(shortest, length);
                }
        const double tolerance = 1e-6 * shortest;
        joined_.resize(points_.size());
        std::iota(joined_.begin(), joined_.end(), 0);
        std::vector<int> order = joined_;
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return points_[a][0] < points_[b][0]; });
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (joined_[order[i]] != order[i]) continue;
            for (std::size_t j = i + 1; j < order.size() && points_[order[j]][0] - points_[order[i]][0] <= tolerance;
                 ++j)
                if (joined_[order[j]] == order[j] && (points_[order[j]] - points_[order[i]]).norm() <= tolerance)
                    joined_[order[j]] = order[i];
        }
    }

    int node(int point) {
        int& n = number_[joined_[point]];
        if (n < 0) {
            n = static_cast<int>(cells_.x.size());
            cells_.x.push_back(points_[joined_[point]]);
            lengths_.emplace_back(0, 0);
        }
        return n;
    }

    void addBody(int b) {
        const auto& body = description_.bodies[b];
        const int group = groupOf(3, body.group, body.places.of("group"));
        for (const auto& t : file_.cells) {
            if (t.group != group) continue;
            Simplex<3> s;
            for (int k = 0; k < 4; ++k) s[k] = node(t.nodes[k]);
            double volume = simplexMeasure<3>(cells_.x, s), longest = 0;
            if (volume < 0) std::swap(s[2], s[3]), volume = -volume;
            for (int k = 0; k < 4; ++k)
                for (int l = k + 1; l < 4; ++l) {
                    const double length = (cells_.x[s[k]] - cells_.x[s[l]]).norm();
                    longest = std::max(longest, length);
                    for (const int i : {s[k], s[l]}) lengths_[i].first += length, ++lengths_[i].second;
                }
            if (!(volume > 1e-6 * longest * longest * longest))
                fail(t.line, "the tetrahedron at " + placeOf(cells_.x[s[0]]) + " has no volume");
            for (int k = 0; k < 4; ++k) {
                Face<3> face = oppositeFace<3>(s, k);
                std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
                if (!sides_.insert(face).second)
                    fail(t.line, "the tetrahedron at " + placeOf(cells_.x[s[0]]) + " overlaps another one");
            }
            cells_.cells.push_back(s);
            cells_.label.push_back(b + 1);
        }
    }

    /// A group of triangles as a shape.
    int addGeometry(const std::string& name, const std::string& groupName, const Location& where) {
        const int group = groupOf(2, groupName, where);
        Geometry geometry;
        geometry.name = name;
        geometry.file = file_.file;
        geometry.scaled = true;
        geometry.places[""] = where;
        std::vector<int> number(points_.size(), -1);
        std::set<Face<3>> known;  // a triangle of two entities may come twice
        std::vector<Face<3>> faces;
        for (const auto& t : file_.faces) {
            if (t.group != group) continue;
            Face<3> face;
            for (int k = 0; k < 3; ++k) {
                int& n = number[joined_[t.nodes[k]]];
                if (n < 0) {
                    n = static_cast<int>(geometry.surface.x.size());
                    geometry.surface.x.push_back(points_[joined_[t.nodes[k]]]);
                }
                face[k] = n;
            }
            Face<3> sorted = face;
            std::sort(sorted.begin(), sorted.end());
            if (sorted[0] == sorted[1] || sorted[1] == sorted[2])
                fail(t.line, "the triangle at " + placeOf(points_[t.nodes[0]]) + " has no area");
            if (known.insert(sorted).second) faces.push_back(face);
        }
        geometry.surface.addRegion(groupName, faces);
        checkSurface(geometry);
        description_.geometries.push_back(std::move(geometry));
        return static_cast<int>(description_.geometries.size()) - 1;
    }

    /// A body's size is the mean of its nodes'.
    static void setSizes(SpaceMeshResult& result) {
        for (auto& meshed : result.bodies) {
            double sum = 0;
            for (int c = meshed.first; c < meshed.last; ++c)
                for (const int i : cellsOf(result, meshed).nodes[c]) sum += result.state.nodes.h[i] / 4;
            meshed.size = sum / std::max(1, meshed.last - meshed.first);
        }
    }
    static const Cells<3>& cellsOf(const SpaceMeshResult& result, const SpaceMeshedBody& meshed) {
        return meshed.fluid ? result.state.mesh.fluid : result.state.mesh.solid;
    }

    SpaceDescription& description_;
    const ForeignMeshOf<3>& file_;
    Points<3> points_;                             // of the file, in metres
    std::vector<int> joined_;                      // per point: the one that stands for it
    std::vector<int> number_;                      // per point: its node or -1
    std::vector<std::pair<double, int>> lengths_;  // of the edges at a node: sum and number
    std::set<Face<3>> sides_;                      // of all tetrahedra, outwards
    Tetrahedra cells_;
};

}  // namespace

SpaceMeshResult takeSpaceMesh(SpaceDescription description, const ForeignMeshOf<3>& file) {
    if (file.cells.empty()) throw UserError("there is no tetrahedron in \"" + file.file + "\"", {file.file, 0});
    return SpaceTaker(description, file).take();
}

}  // namespace pfem
