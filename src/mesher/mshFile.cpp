#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dictionary/files.hpp"
#include "mesher/meshFile.hpp"
#include "mesher/mshBinary.hpp"
#include "mesher/mshGroups.hpp"

namespace pfem {

namespace {

/// Gmsh's number of an element of first order, and how many nodes it has.
enum ElementType { line = 1, triangle = 2, quadrangle = 3, tetrahedron = 4, point = 15 };

template <int Dim>
class MshReader {
public:
    MshReader(MshLines lines, const std::string& file) : lines_(std::move(lines)) { mesh_.file = file; }

    /// Whatever the order of the sections; those that are not needed are stepped over.
    ForeignMeshOf<Dim> read() {
        findSections();
        demandSection("MeshFormat");
        readFormat();
        if (goTo("PhysicalNames")) groups_.readNames(lines_);
        if (new_ && goTo("Entities")) groups_.readEntities(lines_);
        if (new_ && goTo("PartitionedEntities")) groups_.readPartitionedEntities(lines_);
        demandSection("Nodes");
        new_ ? readNodes4() : readNodes2();
        if constexpr (Dim == 2) checkPlane();
        demandSection("Elements");
        new_ ? readElements4() : readElements2();
        if (!inGroup_)
            mesh_.remark = new_ ? "No element of it is in a physical group."
                                : "No element of it is in a physical group. (With Mesh.SaveAll = 1 Gmsh leaves them "
                                  "out of format 2.2: save "
                                  "without it, or in format 4.1.)";
        return std::move(mesh_);
    }

private:
    /// One of these would contradict another one of its name; all others may come as often as they like.
    static bool isSingle(const std::string& section) {
        static const std::vector<std::string> names = {"MeshFormat",          "PhysicalNames", "Entities",
                                                       "PartitionedEntities", "Nodes",         "Elements"};
        return std::find(names.begin(), names.end(), section) != names.end();
    }

    void findSections() {
        while (lines_.next()) {
            if (lines_.word(0).front() != '$')
                lines_.fail(fmt::format("a section like $Nodes expected, '{}' found", lines_.word(0)));
            const std::string name(lines_.word(0).substr(1));
            if (name == "NOD") lines_.fail("its format is that of Gmsh's version 1: save it as 2.2 or 4.1");
            // 2.2 with places on the geometry behind each node's coordinates
            const std::string section = name == "ParametricNodes" ? "Nodes" : name;
            if (isSingle(section) && !sections_.emplace(section, lines_.place()).second)
                lines_.fail("a second $" + name);
            skipTo("$End" + name);
        }
        end_ = lines_.place();
    }

    void skipTo(const std::string& end) {
        while (lines_.next())
            if (lines_.word(0) == end) return;
        lines_.fail("the file ends without " + end);
    }

    bool goTo(const std::string& section) {
        const auto found = sections_.find(section);
        lines_.goTo(found == sections_.end() ? end_ : found->second);
        return found != sections_.end();
    }

    void demandSection(const std::string& section) {
        if (!goTo(section)) lines_.fail(fmt::format("there is no ${}", section));
    }

    void readFormat() {
        lines_.demand("MeshFormat", 3);
        const auto version = lines_.word(0);
        if (version != "2.2" && version != "4.1")
            lines_.fail(fmt::format("its format is {}: save it as 2.2 or 4.1 (gmsh -format msh41)", version));
        if (lines_.whole(1) != 0) lines_.fail("it is binary: save it as text (Mesh.Binary = 0)");
        new_ = version == "4.1";
    }

    void addNode(long tag, std::size_t first) {
        const double z = std::abs(lines_.real(first + 2));
        if (z > highest_.z) highest_ = {z, lines_.number()};
        if (!index_.emplace(tag, static_cast<int>(mesh_.x.size())).second)
            lines_.fail(fmt::format("a second node {}", tag));
        Vec<Dim> x;
        for (int d = 0; d < Dim; ++d) x[d] = lines_.real(first + static_cast<std::size_t>(d));
        mesh_.x.push_back(x);
    }

    /// Geometry that was turned or moved in space lies in the plane but for rounding.
    void checkPlane() const {
        if (mesh_.x.empty()) return;
        Vec<2> low = mesh_.x.front(), high = low;
        for (const auto& x : mesh_.x) low = low.cwiseMin(x), high = high.cwiseMax(x);
        if (highest_.z > 1e-6 * (high - low).norm())
            lines_.fail(fmt::format("the node leaves the plane z = 0 by {:g}", highest_.z), highest_.line);
    }

    void readNodes2() {
        lines_.demand("Nodes", 1);
        for (long n = lines_.count(0); n > 0; --n) {
            lines_.demand("Nodes", 4);
            addNode(lines_.whole(0), 1);
        }
    }

    void readNodes4() {
        lines_.demand("Nodes", 4);
        for (long blocks = lines_.count(0); blocks > 0; --blocks) {
            lines_.demand("Nodes", 4);
            std::vector<long> tags;
            const long n = lines_.count(3);
            for (long k = 0; k < n; ++k) {
                lines_.demand("Nodes", 1);
                tags.push_back(lines_.whole(0));
            }
            for (const long tag : tags) {
                lines_.demand("Nodes", 3);
                addNode(tag, 0);
            }
        }
    }

    void readElements2() {
        lines_.demand("Elements", 1);
        for (long n = lines_.count(0); n > 0; --n) {
            lines_.demand("Elements", 3);
            const long tags = lines_.count(2);
            lines_.need(3 + static_cast<std::size_t>(tags));
            const long physical = tags > 0 ? lines_.whole(3) : 0, entity = tags > 1 ? lines_.whole(4) : 0;
            addElement(lines_.whole(1), 3 + static_cast<std::size_t>(tags), entity,
                       physical == 0 ? std::vector<long>{} : std::vector<long>{physical});
        }
    }

    void readElements4() {
        lines_.demand("Elements", 4);
        for (long blocks = lines_.count(0); blocks > 0; --blocks) {
            lines_.demand("Elements", 4);
            const int dimension = static_cast<int>(lines_.whole(0));
            const long entity = lines_.whole(1), type = lines_.whole(2);
            const auto& groups = groups_.of(dimension, entity);
            for (long n = lines_.count(3); n > 0; --n) {
                lines_.demand("Elements", 2);
                addElement(type, 1, entity, groups);
            }
        }
    }

    /// Once for each of its groups; without any it is in one that is called as its entity.
    void addElement(long type, std::size_t first, long entity, const std::vector<long>& groups) {
        if (type == point) return;
        if (type == 8 || type == 9 || type == 11) lines_.fail("elements of second order: mesh with order 1");
        if (type == quadrangle) lines_.fail("a quadrangle: mesh with triangles");
        if (type >= 5 && type <= 7) lines_.fail("a hexahedron, prism or pyramid: mesh with tetrahedra");
        if (Dim == 2 && type == tetrahedron)
            lines_.fail("a tetrahedron: for a mesh in space write dimension 3; into meshDict");
        if (type != line && type != triangle && type != tetrahedron)
            lines_.fail(fmt::format(
                "Gmsh's element type {}: only lines (1), triangles (2) and tetrahedra (4) are possible", type));
        if (Dim == 3 && type == line) return;
        const int dimension = type == tetrahedron ? 3 : static_cast<int>(type);
        lines_.need(first + static_cast<std::size_t>(dimension) + 1);
        const char* word = type == line ? "curve" : type == triangle ? "surface" : "volume";
        if (groups.empty())
            add(dimension, first, entity == 0 ? -1 : groupNamed(dimension, fmt::format("{} {}", word, entity)));
        for (const long tag : groups) add(dimension, first, groupNamed(dimension, groups_.name(dimension, tag)));
        inGroup_ = inGroup_ || !groups.empty();
    }

    void add(int dimension, std::size_t first, int group) {
        if (dimension == Dim)
            mesh_.cells.push_back({nodes<Dim + 1>(first), group, lines_.number()});
        else
            mesh_.faces.push_back({nodes<Dim>(first), group, lines_.number()});
    }

    template <int N>
    std::array<int, N> nodes(std::size_t first) const {
        std::array<int, N> found;
        for (int k = 0; k < N; ++k) found[k] = node(first + static_cast<std::size_t>(k));
        return found;
    }

    int node(std::size_t i) const {
        const auto found = index_.find(lines_.whole(i));
        if (found == index_.end()) lines_.fail(fmt::format("there is no node {}", lines_.whole(i)));
        return found->second;
    }

    int groupNamed(int dimension, const std::string& name) {
        if (const int known = mesh_.groupNamed(dimension, name); known >= 0) return known;
        mesh_.groups.push_back({dimension, name});
        return static_cast<int>(mesh_.groups.size()) - 1;
    }

    struct Highest {
        double z = 0;
        int line = 0;
    };

    MshLines lines_;
    std::map<std::string, MshLines::Place> sections_;  // behind their first lines
    MshLines::Place end_;
    bool new_ = false;  // 4.1
    MshGroups groups_;
    std::map<long, int> index_;  // node tag -> index
    Highest highest_;
    bool inGroup_ = false;  // any element
    ForeignMeshOf<Dim> mesh_;
};

}  // namespace

template <int Dim>
ForeignMeshOf<Dim> readMsh(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::string content = fileText(file, {});
    const bool binary = isBinaryMsh(content);
    if (binary) content = textOfBinaryMsh(content, name);
    return MshReader<Dim>(MshLines(std::move(content), name, !binary), name).read();
}

template ForeignMeshOf<2> readMsh<2>(const std::filesystem::path&);
template ForeignMeshOf<3> readMsh<3>(const std::filesystem::path&);

}  // namespace pfem
